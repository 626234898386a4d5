// SPDX-License-Identifier: Apache-2.0
// Files that are either old or new, never torn; and the sentences for when the disk says no.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace kerf {

// Replaces the file by `content`: written beside it, brought to the disk, renamed, and the folder
// brought to the disk. At any instant the path holds the old content or the new. Throws UserError
// (exit_files); the old content is then still there.
void write_file(const std::filesystem::path& path, std::string_view content);

// Adds to the end of a file that is there. Throws UserError (exit_files).
void append_to_file(const std::filesystem::path& path, std::string_view content);

// Brings a file that was added to to the disk. Throws UserError (exit_files).
void sync_file(const std::filesystem::path& path);

// Throws UserError (exit_files) when there is no such file or it cannot be read.
std::string read_file(const std::filesystem::path& path);

// Makes a folder in one that is there: a result folder that vanished must not come back empty.
// Throws UserError (exit_files).
void make_inner_folder(const std::filesystem::path& folder);

// Makes a folder and those around it. Throws UserError (exit_files).
void make_folder(const std::filesystem::path& folder);

// Holds a folder for this process as long as it lives; the system lets go of it when the process
// ends in any way. Throws UserError (exit_files) when another process holds it.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_ = -1;
};

}  // namespace kerf
