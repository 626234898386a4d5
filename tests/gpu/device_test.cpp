// SPDX-License-Identifier: Apache-2.0
// The option --device: its refusals, and the device that a result names.
#include "engine/device.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/processor.hpp"
#include "faults/program.hpp"
#include "output/files.hpp"
#include "support/temporary_folder.hpp"

namespace kerf::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class DeviceTest : public testing::Test {
 protected:
  ~DeviceTest() override {
    unsetenv("KERF_GPU_ENGINE");
    set_device(Device::cpu);
  }

  Ending kerf(const std::string& library, const std::vector<std::string>& words) const {
    setenv("KERF_GPU_ENGINE", library.c_str(), 1);
    return Program(words, folder_ / "words.txt").wait();
  }
  std::string small_case() const {
    const std::string file = folder_ / "drop.toml";
    write_file(file, R"toml(
title = "A falling drop"
dimension = 2
[time]
end = "0.2 ms"
[[body]]
name = "drop"
material = "water"
shape = { type = "box", minimum = ["0 mm", "0 mm"], maximum = ["4 mm", "4 mm"] }
spacing = "0.5 mm"
velocity = ["0 m/s", "-1 m/s"]
)toml");
    return file;
  }

  TemporaryFolder folder_;
};

TEST_F(DeviceTest, AProgramWithoutTheEngineNamesTheRemedy) {
  const Ending end = kerf("/nowhere/libkerf_gpu.so",
                          {"run", small_case(), "--out", folder_ / "out", "--device", "gpu"});
  EXPECT_EQ(end.exit_code, exit_bad_input);
  EXPECT_THAT(end.output, AllOf(HasSubstr("--device gpu"), HasSubstr("/nowhere/libkerf_gpu.so"),
                                HasSubstr("Allowed here: cpu"), HasSubstr("cmake --preset cuda")));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out")) << "nothing is written before that";
}

TEST_F(DeviceTest, EveryCommandRefusesAMissingEngine) {
  const std::string file = small_case();
  const std::vector<std::vector<std::string>> commands{
      {"check", file}, {"bench", file, "--seconds", "0.1"}, {"verify", "tank"}};
  for (std::vector<std::string> words : commands) {
    words.insert(words.end(), {"--device", "gpu"});
    const Ending end = kerf("/nowhere/libkerf_gpu.so", words);
    EXPECT_EQ(end.exit_code, exit_bad_input) << words[0];
    EXPECT_THAT(end.output, HasSubstr("Allowed here: cpu")) << words[0];
  }
}

TEST_F(DeviceTest, UnknownDevicesAreRefused) {
  const Ending end = kerf("", {"run", small_case(), "--device", "tpu"});
  EXPECT_EQ(end.exit_code, 2);
  EXPECT_THAT(end.output, AllOf(HasSubstr("--device"), HasSubstr("cpu"), HasSubstr("gpu")));
}

TEST_F(DeviceTest, InvalidLibrariesAreRefused) {
  const std::string file = folder_ / "libkerf_gpu.so";
  write_file(file, "no library");
  setenv("KERF_GPU_ENGINE", file.c_str(), 1);
  const std::string processor = device_name();
  const std::string message = message_of<UserError>([] { set_device(Device::gpu); });
  EXPECT_THAT(message, AllOf(HasSubstr(file + " cannot be loaded"), HasSubstr("--preset cuda")));
  EXPECT_EQ(device_name(), processor);
}

TEST_F(DeviceTest, ALibraryOfAnotherVersionIsNotUsed) {
  const Ending end = kerf(KERF_OLD_ENGINE, {"check", small_case(), "--device", "gpu"});
  EXPECT_EQ(end.exit_code, exit_bad_input);
  EXPECT_THAT(end.output, HasSubstr("belongs to 0.0.0"));
}

TEST_F(DeviceTest, AMachineWithoutAGpuIsReported) {
  const Ending end = kerf(KERF_IDLE_ENGINE, {"check", small_case(), "--device", "gpu"});
  EXPECT_EQ(end.exit_code, exit_bad_input);
  EXPECT_THAT(end.output, AllOf(HasSubstr("--device gpu: there is no NVIDIA GPU"),
                                HasSubstr("Allowed here: cpu"), HasSubstr("nvidia-smi")));
}

TEST_F(DeviceTest, TheResultNamesTheDevice) {
  const std::string out = folder_ / "out";
  const auto device = [&] {
    return nlohmann::json::parse(read_file(out + "/result.json")).at("device").get<std::string>();
  };
  const std::vector<std::string> words{"run", small_case(), "--out", out, "--force"};
  ASSERT_EQ(kerf("", words).exit_code, 0);
  EXPECT_EQ(device(), processor_name());
  std::vector<std::string> on_gpu = words;
  on_gpu.insert(on_gpu.end(), {"--device", "gpu"});
  const Ending end = kerf(KERF_EMULATED_ENGINE, on_gpu);
  ASSERT_EQ(end.exit_code, 0) << end.output;
  EXPECT_EQ(device(), "GPU emulated on " + processor_name());
  EXPECT_THAT(read_file(out + "/report.html"), HasSubstr("GPU emulated on"));
}

}  // namespace
}  // namespace kerf::test
