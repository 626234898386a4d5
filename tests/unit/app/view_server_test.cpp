// SPDX-License-Identifier: Apache-2.0
// The server of kerf view with the requests of a browser; frames are decompressed by zlib and
// compared with those on the disk.
#include "app/view_server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>
#include <sys/socket.h>
#include <unistd.h>
#include <zlib.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/compare_server.hpp"
#include "app/run_loop.hpp"
#include "core/error.hpp"
#include "input/write_used.hpp"
#include "output/read_frame.hpp"
#include "report/picture.hpp"
#include "support/fake_run.hpp"
#include "support/shell.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

class View : public testing::Test {
 protected:
  void SetUp() override {
    test::run_fake(description_, out_);
    server_ = std::make_unique<ViewServer>(out_);
    port_ = server_->bind(0);
    client_ = std::make_unique<httplib::Client>("127.0.0.1", port_);
    thread_ = std::thread([this] { server_->serve(); });
  }
  void TearDown() override {
    server_->stop();
    thread_.join();
  }
  nlohmann::json run() { return nlohmann::json::parse(get("run.json")->body); }
  httplib::Result get(const std::string& address, const httplib::Headers& headers = {}) {
    return client_->Get(server_->path() + address, headers);
  }
  // Returns a socket that is connected to the server.
  int connected() const {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port_));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int open = socket(AF_INET, SOCK_STREAM, 0);
    EXPECT_EQ(connect(open, reinterpret_cast<sockaddr*>(&address), sizeof(address)), 0);
    return open;
  }

  test::TemporaryFolder folder_;
  std::filesystem::path out_ = folder_ / "out";
  Case description_ = test::fake_case();
  int port_ = 0;
  std::unique_ptr<ViewServer> server_;
  std::unique_ptr<httplib::Client> client_;
  std::thread thread_;
};

std::string inflated(const std::string& packed) {
  std::string bytes(1 << 22, '\0');
  uLongf size = bytes.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                       reinterpret_cast<const Bytef*>(packed.data()), packed.size()),
            Z_OK);
  bytes.resize(size);
  return bytes;
}

TEST_F(View, ItsPortIsItsOwn) {
  ViewServer other(out_);
  EXPECT_THROW(other.bind(port_), UserError);
}

TEST_F(View, ServesThePageOfARun) {
  const auto page = get("");
  ASSERT_TRUE(page);
  EXPECT_EQ(page->status, 200);
  EXPECT_THAT(page->body, testing::HasSubstr("class=\"verdict"));
  EXPECT_EQ(get("nothing")->status, 404);
}

// A page of another site may lead a name of its own to this machine.
TEST_F(View, AnswersToThisMachineOnly) {
  constexpr int forbidden = 403;
  EXPECT_EQ(get("run.json", {{"Host", "localhost:8080"}})->status, 200);
  EXPECT_EQ(get("run.json", {{"Host", "example.org"}})->status, forbidden);
  EXPECT_EQ(get("run.json", {{"Host", "127.0.0.1.example.org"}})->status, forbidden);
  EXPECT_EQ(get("run.json", {{"Origin", "http://example.org"}})->status, forbidden);
  EXPECT_EQ(get("run.json", {{"Origin", "http://localhost:99"}})->status, 200);
}

// Who does not know the address that was printed reads nothing.
TEST_F(View, NeedsTheTokenOfItsAddress) {
  EXPECT_EQ(server_->path().size(), 34u);
  for (const char* address : {"/", "/run.json", "/frame/0", "/0123456789abcdef/run.json"})
    EXPECT_EQ(client_->Get(address)->status, 404) << address;
  EXPECT_NE(ViewServer(out_).path(), server_->path());
}

TEST_F(View, AFrameThatIsNotThereIsNotFound) {
  const auto answer = get("frame/99");
  EXPECT_EQ(answer->status, 404);
  EXPECT_THAT(answer->body, testing::StartsWith("there is no frame 99: the run has "));
}

// A request without end is refused long before it fills the memory.
TEST_F(View, RefusesRequestsWithoutEnd) {
  const std::string start = "GET " + server_->path() + "run.json HTTP/1.1\r\nHost: 127.0.0.1\r\n";
  const std::string header = "X-More: " + std::string(1000, 'y') + "\r\n";
  const std::string post = "POST " + server_->path() +
                           "save HTTP/1.1\r\nHost: 127.0.0.1\r\nTransfer-Encoding: chunked\r\n\r\n";
  const std::string chunk = "400\r\n" + std::string(0x400, 'z') + "\r\n";
  // What a request begins with, and what is then sent again and again.
  for (const auto& [first, again] :
       {std::pair{std::string(), std::string(1000, 'x')}, std::pair{start, header},
        std::pair{start, std::string("a:\r\n")}, std::pair{post, chunk}}) {
    const int open = connected();
    std::string block = first;
    std::size_t sent = 0;
    constexpr std::size_t endless = 110'000'000;
    while (sent < endless && send(open, block.data(), block.size(), MSG_NOSIGNAL) >= 0) {
      sent += block.size();
      block.clear();
      while (block.size() < 100'000) block += again;
    }
    close(open);
    // The server reads 64 KiB, or a body of 8 MiB in chunks; the rest is in the buffers of the
    // system.
    EXPECT_LT(sent, 30'000'000u) << first;
  }
  EXPECT_EQ(get("run.json")->status, 200);
}

// Clients that send nothing do not keep the others waiting.
TEST_F(View, AnswersBesideSlowClients) {
  std::vector<int> slow;
  for (int n = 0; n < 20; ++n) {
    slow.push_back(connected());
    ASSERT_EQ(send(slow.back(), "GET /", 5, 0), 5);
  }
  const auto before = std::chrono::steady_clock::now();
  EXPECT_EQ(get("run.json")->status, 200);
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(3));
  for (const int open : slow) close(open);
}

TEST_F(View, FramesAreThoseOnTheDisk) {
  const auto description = run();
  const auto files = frame_files(out_);
  ASSERT_GT(files.size(), 2u);
  ASSERT_EQ(description.at("frames").size(), files.size());
  const auto fields = description.at("fields").size();
  for (std::size_t n = 0; n < files.size(); ++n) {
    const Frame frame = read_frame(files[n].path, description_.dimension);
    const auto& entry = description.at("frames").at(n);
    const std::size_t count = frame.position.size();
    ASSERT_EQ(entry.at("count").get<std::size_t>(), count);
    EXPECT_EQ(entry.at("time").get<double>(), frame.time);
    const std::string bytes = inflated(get(entry.at("url").get<std::string>())->body);
    const auto dimension = static_cast<std::size_t>(description_.dimension);
    ASSERT_EQ(bytes.size(), count * (2 * dimension + 2 + fields));
    for (std::size_t a = 0; a < dimension; ++a) {
      const double low = description.at("minimum").at(a), high = description.at("maximum").at(a);
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = 2 * (a * count + i);
        const unsigned code = static_cast<unsigned char>(bytes[at]) +
                              256u * static_cast<unsigned char>(bytes[at + 1]);
        const double place = std::clamp(frame.position[i][a], low, high);
        EXPECT_NEAR(low + code / 65535.0 * (high - low), place, 0.51 * (high - low) / 65535.0);
      }
    }
    for (std::size_t i = 0; i < count; ++i)
      EXPECT_EQ(bytes[2 * dimension * count + i], static_cast<char>(frame.category[i]));
  }
}

TEST_F(View, FollowsARunInProgress) {
  EXPECT_EQ(run().at("live"), false);
  std::filesystem::remove(out_ / "result.json");
  EXPECT_EQ(run().at("live"), true);
  EXPECT_THAT(get("")->body, testing::HasSubstr("The run is in progress"));
  EXPECT_GT(run().at("curves").at("time").size(), 2u);
}

// The page of two runs has the numbers of both and leads to the frames of each.
TEST(CompareServer, ServesTwoRuns) {
  const test::TemporaryFolder folder;
  Case other = test::fake_case();
  other.title = "The other run";
  test::run_fake(test::fake_case(), folder / "a");
  test::run_fake(other, folder / "b");
  CompareServer server(folder / "a", folder / "b");
  httplib::Client client("127.0.0.1", server.bind(0));
  std::thread thread([&] { server.serve(); });
  const auto get = [&](const std::string& address) { return client.Get(server.path() + address); };
  const std::string page = get("")->body;
  EXPECT_THAT(page, testing::HasSubstr("id=\"kerf-compared\""));
  EXPECT_THAT(page, testing::HasSubstr("id=\"kerf-numbers\""));
  EXPECT_THAT(page, testing::HasSubstr("The other run"));
  for (const std::string place : {"first/", "second/"}) {
    const auto run = nlohmann::json::parse(get(place + "run.json")->body);
    EXPECT_EQ(run.at("title") == "The other run", place == "second/");
    const auto address = run.at("frames").at(1).at("url").get<std::string>();
    EXPECT_THAT(address, testing::StartsWith(place));
    EXPECT_EQ(get(address)->status, 200);
  }
  std::filesystem::remove(folder / "b/result.json");  // as in a run that proceeds
  EXPECT_THAT(get("")->body, testing::HasSubstr("once both runs have ended"));
  server.stop();
  thread.join();
}

TEST(ViewFolder, MustContainARun) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(test::message_of<UserError>([&] { ViewServer server(folder / ""); }),
              testing::HasSubstr("contains no run of Kerf"));
}

TEST_F(View, EndsIfStoppedBeforeTheStart) {
  ViewServer server(out_);
  server.bind(0);
  server.stop();
  server.serve();  // returns
}

TEST_F(View, AMovieHasAllFrames) {
  if (!test::is_installed("ffmpeg") || !test::is_installed("ffprobe"))
    GTEST_SKIP() << "there is no ffmpeg (Debian: apt-get install ffmpeg)";
  std::size_t drawn = 0;
  const auto file =
      write_movie(out_, description_, [&](std::size_t done, std::size_t) { drawn = done; });
  const std::size_t frames = frame_files(out_).size();
  ASSERT_GT(frames, 2u);
  EXPECT_EQ(drawn, frames);
  const std::string counted = test::printed_by(
      "ffprobe -v error -count_frames -select_streams v:0 -show_entries stream=nb_read_frames "
      "-of csv=p=0 '" +
      file.string() + "'");
  ASSERT_FALSE(counted.empty());
  EXPECT_EQ(std::stoul(counted), frames);
}

// A computer without ffmpeg is simulated by an empty search path.
TEST_F(View, AMovieWithoutFfmpegNamesThePackage) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", (folder_ / "nothing").c_str(), 1);
  const std::string refusal = test::message_of<UserError>(
      [&] { write_movie(out_, description_, [](std::size_t, std::size_t) {}); });
  setenv("PATH", path.c_str(), 1);
  EXPECT_THAT(refusal, testing::HasSubstr("apt-get install ffmpeg"));
}

}  // namespace
}  // namespace kerf
