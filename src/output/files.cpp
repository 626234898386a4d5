// SPDX-License-Identifier: Apache-2.0
#include "output/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <utility>

#include "core/error.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;

const char* remedy_of(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "Free space on that disk, or write to another with --out.";
    case EACCES:
    case EPERM:
    case EROFS:
      return "Choose a writable folder with --out, or change its permissions.";
    case ENOENT:
      return "The folder does not exist: restore it, or choose another.";
    case ENOTDIR:
      return "It is a file, or its path leads through one: choose another folder with --out.";
    case EFBIG:
      return "The file would be larger than is allowed here: raise the limit.";
    default:
      return "Check the disk and the path.";
  }
}

[[noreturn]] void fail(const char* what, const fs::path& path, int error) {
  throw UserError(
      fmt::format("{} {}: {}. {}", what, path.string(), std::strerror(error), remedy_of(error)),
      exit_files);
}

// An open file. Write errors become UserErrors that name `shown`, the path that the user gave.
class OpenFile {
 public:
  OpenFile(const fs::path& path, int flags, fs::path shown) : shown_(std::move(shown)) {
    descriptor_ = ::open(path.c_str(), flags | O_CLOEXEC, 0644);
    if (descriptor_ < 0) fail("cannot write", shown_, errno);
  }
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  void write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t written = ::write(descriptor_, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail("cannot write", shown_, errno);
      content.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  void sync() {
    if (::fsync(descriptor_) != 0) fail("cannot write", shown_, errno);
  }
  void close() {
    // Network file systems report a full disk only at this call.
    if (::close(std::exchange(descriptor_, -1)) != 0) fail("cannot write", shown_, errno);
  }

 private:
  fs::path shown_;
  int descriptor_ = -1;
};

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

void sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) fail("cannot write to", folder, errno);
  const int result = ::fsync(descriptor);
  const int error = errno;
  ::close(descriptor);
  // Some file systems do not support this call for folders and do not need it.
  if (result != 0 && error != EINVAL && error != ENOTSUP) fail("cannot write to", folder, error);
}

}  // namespace

void write_file(const fs::path& path, std::string_view content) {
  const fs::path beside = folder_of(path) / fmt::format(".{}.tmp", path.filename().string());
  try {
    OpenFile file(beside, O_WRONLY | O_CREAT | O_TRUNC, path);
    file.write(content);
    file.sync();
    file.close();
    if (::rename(beside.c_str(), path.c_str()) != 0) fail("cannot write", path, errno);
  } catch (...) {
    ::unlink(beside.c_str());  // the incomplete file would occupy a full disk
    throw;
  }
  sync_folder(folder_of(path));
}

void append_to_file(const fs::path& path, std::string_view content) {
  OpenFile file(path, O_WRONLY | O_APPEND, path);
  file.write(content);
  file.close();
}

void sync_file(const fs::path& path) {
  OpenFile file(path, O_WRONLY, path);
  file.sync();
  file.close();
}

std::string read_file(const fs::path& path) {
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail("cannot read", path, errno != 0 ? errno : EIO);
  std::ostringstream content;
  content << stream.rdbuf();
  if (stream.bad()) fail("cannot read", path, errno != 0 ? errno : EIO);
  return std::move(content).str();
}

void make_inner_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directory(folder, error);
  if (error) fail("cannot make the folder", folder, error.value());
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail("cannot make the folder", folder, error.value());
  if (!fs::is_directory(folder)) fail("cannot make the folder", folder, ENOTDIR);
}

FolderLock::FolderLock(const fs::path& folder) {
  descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0) fail("cannot open the folder", folder, errno);
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(std::exchange(descriptor_, -1));
  throw UserError(fmt::format("{} is in use by another run. Wait until it ends, or choose another "
                              "folder with --out.",
                              folder.string()),
                  exit_files);
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace kerf
