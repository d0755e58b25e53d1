// SPDX-License-Identifier: MIT
#include "file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <random>
#include <system_error>
#include <utility>

#include "error.hpp"

namespace detent::cli {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t largest_file = std::size_t{1} << 30;

std::string last_error() { return std::strerror(errno); }

void check_name(const std::string& path, const char* what) {
  if (path.empty()) throw InputError(std::string(what) + " has no name; give it one");
  if (path.find('\0') != std::string::npos) {
    throw InputError(path, {}, "has a zero byte in its name; correct the name");
  }
}

/// A temporary name in the folder of `target` that simultaneous runs do not share. It is short,
/// because the target's own name may have the maximum length.
fs::path temporary_name(const fs::path& target) {
  std::random_device random;
  return target.parent_path() / (".detent-part-" + std::to_string(random()));
}

/// The file that links lead to, even if it does not exist yet.
fs::path linked_file(fs::path path) {
  constexpr int most_links = 40;
  std::error_code error;
  for (int i = 0; i < most_links && fs::is_symlink(fs::symlink_status(path, error)); ++i) {
    const auto link = fs::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / link;
  }
  return path;
}

/// Keeps the owner of a replaced file, where the system allows it.
void copy_permissions(const struct stat& from, int to) {
  [[maybe_unused]] const int is_refused = fchown(to, from.st_uid, from.st_gid);
  fchmod(to, from.st_mode & 0777);
}

}  // namespace

std::string read_file(const std::string& path) {
  check_name(path, "the input");
  std::error_code error;
  const auto status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    throw InputError(path, {}, "no such file; check the path");
  }
  if (status.type() == fs::file_type::directory) {
    throw InputError(path, {}, "is a directory; name a file in it");
  }
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw InputError(path, {}, "cannot be opened: " + last_error() + "; check its permissions");

  std::string content;
  std::array<char, 1 << 16> buffer{};
  while (stream.read(buffer.data(), buffer.size()) || stream.gcount() > 0) {
    content.append(buffer.data(), static_cast<std::size_t>(stream.gcount()));
    if (content.size() > largest_file) {
      throw InputError(path, {}, "larger than 1 GiB; split it");
    }
  }
  if (stream.bad()) throw InputError(path, {}, "cannot be read to its end; check the disk");
  return content;
}

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  check_name(path_, "the output");
  struct stat status {};
  const bool exists = stat(path_.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) fail("cannot be written");
  if (exists && S_ISDIR(status.st_mode)) {
    throw InputError(path_, {}, "is a directory; name a file in it");
  }
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail("cannot be written");
    return;
  }
  target_ = linked_file(path_);
  if (exists && access(target_.c_str(), W_OK) != 0) fail("cannot be written");
  part_.own(temporary_name(target_).string());
  descriptor_ = open(part_.path().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail("cannot be written");
  if (exists) copy_permissions(status, descriptor_);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const auto written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot be written");
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OutputFile::commit() {
  if (close(std::exchange(descriptor_, -1)) != 0) fail("cannot be written");
  if (part_.path().empty()) return;
  if (std::rename(part_.path().c_str(), target_.c_str()) != 0) fail("cannot be replaced");
  part_.release();
}

void OutputFile::fail(const std::string& what) const {
  const bool is_full = errno == ENOSPC || errno == EDQUOT || errno == EFBIG;
  throw InputError(
      path_, {},
      what + ": " + last_error() + (is_full ? "; free some space" : "; choose another path"));
}

}  // namespace detent::cli
