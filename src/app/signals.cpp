// SPDX-License-Identifier: Apache-2.0
#include "app/signals.hpp"

namespace kerf {
namespace {

constexpr int watched[] = {SIGINT, SIGTERM, SIGHUP};
volatile std::sig_atomic_t noted = 0;

void note(int signal) {
  noted = signal;
}

}  // namespace

StopSignals::StopSignals() {
  noted = 0;
  struct sigaction action = {};
  action.sa_handler = note;
  // The handler is used once; a second signal has the default action.
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigemptyset(&action.sa_mask);
  for (int i = 0; i < count_; ++i) sigaction(watched[i], &action, &before_[i]);
}

StopSignals::~StopSignals() {
  for (int i = 0; i < count_; ++i) sigaction(watched[i], &before_[i], nullptr);
}

int StopSignals::caught() const {
  return noted;
}

}  // namespace kerf
