// SPDX-License-Identifier: Apache-2.0
#include "engine/lead.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <cstring>

#include "core/error.hpp"
#include "engine/instantiate.hpp"
#include "engine/mpi/archive_message.hpp"
#include "parallel/ranks.hpp"

namespace kerf {
namespace {

// What rank 0 asks of the others: a function of Simulation, or a run, or the end.
enum class Request : std::uint8_t {
  make,
  advance,
  frame,
  frame_of_cut,
  layout,
  balance,
  particles,
  probe_values,
  pair_interactions,
  neighbours_per_particle,
  bytes_per_particle,
  save,
  restore,
  end
};

void ask(Request request) {
  ranks::Bytes message{static_cast<std::byte>(request)};
  ranks::broadcast(message);
}

// The other ranks wait for this one where it stops within a step, so that all are ended.
[[noreturn]] void give_up(const std::exception& error) {
  std::fflush(stdout);
  fmt::print(stderr, "kerf: error: rank {} of {} cannot go on: {}. All ranks are ended.\n",
             ranks::number(), ranks::count(), error.what());
  std::fflush(stderr);
  ranks::abort(exit_run_failed);
}

// A UserError of a run is thrown at every rank, any other error at some.
template <class Work>
auto together(const Work& work) {
  try {
    return work();
  } catch (const UserError&) {
    throw;
  } catch (const std::exception& error) {
    give_up(error);
  }
}

template <class Work>
auto of_all(Request request, const Work& work) {
  ask(request);
  return together(work);
}

// Every call is one of all ranks; what all have is asked of none.
class LedSimulation : public Simulation {
 public:
  explicit LedSimulation(std::unique_ptr<Simulation> own) : own_(std::move(own)) {}

  void advance() override {
    of_all(Request::advance, [this] { own_->advance(); });
  }
  bool finished() const override { return own_->finished(); }
  double time() const override { return own_->time(); }
  std::uint64_t step() const override { return own_->step(); }
  std::size_t particles() const override {
    return of_all(Request::particles, [this] { return own_->particles(); });
  }
  StepInfo last_step() const override { return own_->last_step(); }
  Frame frame() const override {
    return of_all(Request::frame, [this] { return own_->frame(); });
  }
  Frame frame_of_cut() const override {
    return of_all(Request::frame_of_cut, [this] { return own_->frame_of_cut(); });
  }
  Balance balance() const override {
    return of_all(Request::balance, [this] { return own_->balance(); });
  }
  std::uint64_t shifts() const override { return own_->shifts(); }
  Frame layout() const override {
    return of_all(Request::layout, [this] { return own_->layout(); });
  }
  std::vector<double> probe_values() const override {
    return of_all(Request::probe_values, [this] { return own_->probe_values(); });
  }
  double pair_interactions() const override {
    return of_all(Request::pair_interactions, [this] { return own_->pair_interactions(); });
  }
  double neighbours_per_particle() const override {
    return of_all(Request::neighbours_per_particle,
                  [this] { return own_->neighbours_per_particle(); });
  }
  double bytes_per_particle() const override {
    return of_all(Request::bytes_per_particle, [this] { return own_->bytes_per_particle(); });
  }
  std::vector<StageTime> stage_times() const override { return own_->stage_times(); }
  void save(Archive& archive) const override {
    of_all(Request::save, [&] { own_->save(archive); });
  }
  void restore(const Archive& archive) override {
    of_all(Request::restore, [&] {
      ranks::Bytes message = message_of(archive);
      ranks::broadcast(message);
      own_->restore(archive);
    });
  }

 private:
  std::unique_ptr<Simulation> own_;
};

void obey(Request request, Simulation& own) {
  Archive archive;
  switch (request) {
    case Request::advance:
      return own.advance();
    case Request::frame:
      return static_cast<void>(own.frame());
    case Request::frame_of_cut:
      return static_cast<void>(own.frame_of_cut());
    case Request::layout:
      return static_cast<void>(own.layout());
    case Request::balance:
      return static_cast<void>(own.balance());
    case Request::particles:
      return static_cast<void>(own.particles());
    case Request::probe_values:
      return static_cast<void>(own.probe_values());
    case Request::pair_interactions:
      return static_cast<void>(own.pair_interactions());
    case Request::neighbours_per_particle:
      return static_cast<void>(own.neighbours_per_particle());
    case Request::bytes_per_particle:
      return static_cast<void>(own.bytes_per_particle());
    case Request::save:
      return own.save(archive);
    case Request::restore: {
      ranks::Bytes message;
      ranks::broadcast(message);
      return own.restore(archive_of(message));
    }
    case Request::make:
    case Request::end:
      break;
  }
}

}  // namespace

void at_all_ranks(const std::function<void()>& work) {
  std::string problem;
  int code = 0;
  try {
    together([&] { work(); });
  } catch (const UserError& error) {
    problem = error.what();
    code = error.exit_code();
  }
  const std::vector<int> codes = ranks::all(code);
  std::vector<char> text(problem.begin(), problem.end());
  std::vector<std::uint64_t> lengths = ranks::all(std::uint64_t(text.size()));
  text = ranks::collected(text);
  const char* from = text.data();
  for (std::size_t r = 0; r < codes.size(); from += lengths[r], ++r)
    if (codes[r] != 0) throw UserError(std::string(from, lengths[r]), codes[r]);
}

std::unique_ptr<Simulation> make_led(const Case& description) {
  ask(Request::make);
  return together([&] { return std::make_unique<LedSimulation>(make_here(description)); });
}

Lead::~Lead() {
  ask(Request::end);
}

// Signals are for rank 0, which writes a checkpoint.
void follow(const Case& description) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
  std::unique_ptr<Simulation> own;
  while (true) {
    ranks::Bytes message;
    ranks::broadcast(message);
    const auto request = static_cast<Request>(message.at(0));
    if (request == Request::end) return;
    try {
      together([&] {
        if (request == Request::make)
          own = make_here(description);
        else
          obey(request, *own);
      });
    } catch (const UserError&) {  // which rank 0 reports
    }
  }
}

}  // namespace kerf
