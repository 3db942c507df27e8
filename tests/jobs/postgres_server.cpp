#include "postgres_server.h"

#include <pwd.h>
#include <signal.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "base/error.h"
#include "jobs/postgres_database.h"

namespace regarment {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr const char* kPrograms = "/usr/lib/postgresql/15/bin/";
constexpr const char* kUser = "postgres";  // Debian's package makes it; root may run no server
constexpr auto kPatience = 60s;
constexpr auto kLook = 10ms;

// As an ordinary user, and ending with us: a change of user would forget that.
std::vector<std::string> command_of(const std::string& program) {
  if (::geteuid() != 0) return {kPrograms + program};
  const std::string user = kUser;
  return {"/usr/bin/setpriv", "--reuid=" + user,  "--regid=" + user,
          "--init-groups",    "--pdeathsig=KILL", kPrograms + program};
}

void run_to_end(std::vector<std::string> command, const std::vector<std::string>& words) {
  command.insert(command.end(), words.begin(), words.end());
  ChildProcess child(command, {.time = kPatience});
  ChildEnd end;
  while (!child.ended(end)) {
    wait_for_children({&child}, kLook);
    child.look_after();
  }
  if (end.status != 0) throw TemporaryError("initdb: " + end.last_line);
}

// What a server says of itself: its process first, "ready" at the end once it is.
std::string state_in(const fs::path& data) { return bytes_of(data / "postmaster.pid"); }

bool is_ready(const std::string& state) {
  const auto end = state.find_last_not_of(" \n");
  return end != std::string::npos && state.substr(0, end + 1).ends_with("ready");
}

std::vector<pid_t> children_of(pid_t process) {
  const std::string pid = std::to_string(process);
  std::ifstream file("/proc/" + pid + "/task/" + pid + "/children");
  return {std::istream_iterator<pid_t>(file), {}};
}

}  // namespace

bool PostgresServer::is_installed() {
  return fs::exists(std::string(kPrograms) + "initdb") &&
         (::geteuid() != 0 || ::getpwnam(kUser) != nullptr);
}

PostgresServer::PostgresServer(bool durable) : durable_(durable) {
  fs::create_directory(data());
  if (::geteuid() == 0) {
    const passwd* user = ::getpwnam(kUser);
    fs::permissions(folder_.path(), fs::perms(0755));
    for (const fs::path& one : {folder_.path(), data()}) {
      (void)!::chown(one.c_str(), user->pw_uid, user->pw_gid);
    }
  }
  run_to_end(command_of("initdb"),
             {"--pgdata=" + data().string(), "--auth=trust", "--username=regarment",
              "--encoding=UTF8", "--locale=C", "--no-sync", "--no-instructions"});
  start();
}

PostgresServer::~PostgresServer() {
  // Immediately, but giving back what it shares with its processes.
  server_->signal(SIGQUIT);
  ChildEnd end;
  for (const auto until = std::chrono::steady_clock::now() + kPatience;
       !server_->ended(end) && std::chrono::steady_clock::now() < until;) {
    wait_for_children({server_.get()}, kLook);
    server_->look_after();
  }
}

void PostgresServer::start() {
  const std::string on = durable_ ? "on" : "off";
  auto command = command_of("postgres");
  command.insert(command.end(), {"-D", data().string(), "-k", folder_.path().string(), "-c",
                                 "listen_addresses=", "-c", "fsync=" + on, "-c",
                                 "full_page_writes=" + on, "-c", "log_min_messages=panic", "-c",
                                 "max_connections=60", "-c", "shared_buffers=32MB"});
  const auto until = std::chrono::steady_clock::now() + kPatience;
  const std::string before = state_in(data());  // of one that was killed
  while (std::chrono::steady_clock::now() < until) {
    server_ = std::make_unique<ChildProcess>(command);
    ChildEnd end;
    while (!server_->ended(end)) {
      const std::string state = state_in(data());
      if (state != before && is_ready(state)) return;
      wait_for_children({server_.get()}, kLook);
      server_->look_after();
    }
    // Processes of one that was killed may still be on their way out.
    std::this_thread::sleep_for(kLook);
  }
  throw TemporaryError("postgres did not start");
}

void PostgresServer::kill() {
  const pid_t server = std::stoi(state_in(data()));
  std::vector<pid_t> all = children_of(server);
  all.insert(all.begin(), server);
  for (const pid_t one : all) ::kill(one, SIGKILL);
  ChildEnd end;
  while (!server_->ended(end)) {
    wait_for_children({server_.get()}, kLook);
    server_->look_after();
  }
}

std::string PostgresServer::address(const std::string& database) const {
  return "postgresql://regarment@/" + database + "?host=" + folder_.path().string();
}

void PostgresServer::run(const std::string& database, const std::string& sql) const {
  PostgresDatabase(PostgresAddress::parse(address(database))).run(sql);
}

std::string PostgresServer::make_database(const std::string& words) {
  const std::string name = "test" + std::to_string(++databases_);
  run("postgres", "CREATE DATABASE " + name + " " + words);
  return address(name);
}

}  // namespace regarment
