// SPDX-License-Identifier: Apache-2.0
// These functions write files atomically: a path holds either the old content or the new. Their
// errors state the remedy.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace kerf {

// Replaces the file by `content`: it is written beside the file, synchronised with the disk and
// renamed, and the folder is synchronised. At any instant the path holds the old content or the
// new. Throws UserError (exit_files); the old content then remains.
void write_file(const std::filesystem::path& path, std::string_view content);

// Appends to a file that exists. Throws UserError (exit_files).
void append_to_file(const std::filesystem::path& path, std::string_view content);

// Synchronises a file with the disk. Throws UserError (exit_files).
void sync_file(const std::filesystem::path& path);

// Returns the content of a file. Throws UserError (exit_files) when there is no such file or it
// cannot be read.
std::string read_file(const std::filesystem::path& path);

// Makes a folder in an existing one, so that a result folder that was deleted does not come back
// empty. Throws UserError (exit_files).
void make_inner_folder(const std::filesystem::path& folder);

// Makes a folder and its parents. Throws UserError (exit_files).
void make_folder(const std::filesystem::path& folder);

// Locks a folder for this process; the system removes the lock when the process ends in any way.
// Throws UserError (exit_files) when another process has it.
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
