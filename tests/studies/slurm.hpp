// SPDX-License-Identifier: Apache-2.0
// A cluster that consists of this machine, on the loopback interface, for the duration of a test.
#pragma once

#include <fcntl.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <list>
#include <string>
#include <thread>
#include <vector>

#include "output/files.hpp"
#include "study/child_process.hpp"
#include "support/temporary_folder.hpp"

namespace kerf::test {

// A program that runs until it is ended, or until this program ends.
class Daemon {
 public:
  Daemon(const std::vector<std::string>& words, const std::filesystem::path& output) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    process_ = fork();
    if (process_ != 0) return;
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  ~Daemon() {
    kill(process_, SIGTERM);
    waitpid(process_, nullptr, 0);
  }
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

 private:
  pid_t process_ = -1;
};

// Whether a server of this machine could listen at the port.
inline bool is_free(int port) {
  const int server = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_ANY);
  const auto* generic = reinterpret_cast<const sockaddr*>(&address);
  const bool is_bound = bind(server, generic, sizeof(address)) == 0;
  close(server);
  return is_bound;
}
// Two free ports in a row, below those that the system gives to clients (32768 and above), which
// may take one at any time.
inline int two_free_ports() {
  constexpr int first = 20000, pairs = 6000;
  for (int k = 0; k < pairs; ++k) {
    const int port = first + 2 * ((getpid() + k) % pairs);
    if (is_free(port) && is_free(port + 1)) return port;
  }
  return first;
}

class SlurmOfOneNode {
 public:
  // The reason why there is no cluster; empty if it runs.
  std::string start() {
    if (geteuid() != 0) return "starting Slurm's daemons needs root";
    for (const char* program : {"munged", "slurmctld", "slurmd", "sbatch", "scancel"})
      if (output_of(program, {"--version"}).exit_code == -1)
        return std::string(program) + " is not installed (Debian: slurm-wlm, munge)";
    char host[256] = {};
    gethostname(host, sizeof(host) - 1);
    name_ = std::string(host).substr(0, std::string(host).find('.'));
    configure();
    setenv("SLURM_CONF", path("slurm.conf").c_str(), 1);
    begin({"munged", "--force", "--foreground", "--key-file=" + path("munge.key"),
           "--socket=" + path("munge.socket"), "--pid-file=" + path("munge.pid"),
           "--log-file=" + path("munge.log"), "--seed-file=" + path("munge.seed")});
    if (!comes([&] { return std::filesystem::exists(path("munge.socket")); }))
      return "munged did not start";
    begin({"slurmctld", "-D"});
    if (!comes([] { return output_of("squeue", {"--noheader"}).exit_code == 0; }))
      return "slurmctld did not start";
    begin({"slurmd", "-D", "-N", name_});
    const auto is_idle = [] {
      return output_of("sinfo", {"--noheader", "--format=%T"}).output.starts_with("idle");
    };
    return comes(is_idle) ? "" : "slurmd did not start";
  }

  ~SlurmOfOneNode() {
    while (!daemons_.empty()) daemons_.pop_back();  // the last first
    unsetenv("SLURM_CONF");
  }

 private:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void begin(const std::vector<std::string>& words) {
    daemons_.emplace_back(words, path(words[0] + ".txt"));
  }
  template <class Condition>
  static bool comes(const Condition& condition) {
    for (int i = 0; i < 200; ++i) {
      if (condition()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
  }
  void configure() const {
    write_file(path("munge.key"), std::string(64, 'k') + std::to_string(getpid()));
    std::filesystem::permissions(path("munge.key"), std::filesystem::perms::owner_read);
    std::filesystem::permissions(folder_.path(), std::filesystem::perms(0755));
    std::filesystem::create_directory(path("state"));
    std::filesystem::create_directory(path("spool"));
    const int port = two_free_ports();
    write_file(path("slurm.conf"),
               "ClusterName=kerf\nSlurmctldHost=" + name_ +
                   "(127.0.0.1)\nSlurmUser=root\nSlurmdUser=root\nAuthType=auth/munge\n"
                   "AuthInfo=socket=" +
                   path("munge.socket") + "\nStateSaveLocation=" + path("state") +
                   "\nSlurmdSpoolDir=" + path("spool") + "\nSlurmctldPidFile=" + path("ctld.pid") +
                   "\nSlurmdPidFile=" + path("slurmd.pid") + "\nSlurmctldPort=" +
                   std::to_string(port) + "\nSlurmdPort=" + std::to_string(port + 1) +
                   "\nProctrackType=proctrack/linuxproc\nTaskPlugin=task/none\n"
                   "JobAcctGatherType=jobacct_gather/none\nSelectType=select/cons_tres\n"
                   "SelectTypeParameters=CR_Core\nReturnToService=2\nMpiDefault=none\nKillWait=2\n"
                   "NodeName=" +
                   name_ +
                   " NodeAddr=127.0.0.1 CPUs=2 RealMemory=1000 State=UNKNOWN\n"
                   "PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP\n");
  }

  TemporaryFolder folder_;
  std::string name_;
  std::list<Daemon> daemons_;
};

}  // namespace kerf::test
