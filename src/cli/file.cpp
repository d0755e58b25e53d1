// SPDX-License-Identifier: MIT
#include "file.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <random>
#include <system_error>
#include <utility>

#include "error.hpp"

namespace detent::cli {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t largest_file = std::size_t{1} << 30;

std::string last_error() { return std::strerror(errno); }

/// A name that two runs at the same time do not share.
fs::path temporary_name(const fs::path& target) {
  std::random_device random;
  fs::path name = target;
  name += ".part-" + std::to_string(random());
  return name;
}

}  // namespace

std::string read_file(const std::string& path) {
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
    throw InputError(path, {}, "cannot be opened: " + last_error() + "; check its rights");

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
  if (path_.empty()) throw InputError("the output has no name; give one, e.g. out.png");
  std::error_code error;
  const auto status = fs::status(path_, error);
  if (status.type() == fs::file_type::directory) fail("is a directory; name a file in it");

  const bool exists = fs::exists(status);
  target_ = exists ? fs::canonical(path_, error) : fs::path(path_);
  if (error) target_ = path_;
  written_ = exists && !fs::is_regular_file(status) ? target_ : temporary_name(target_);
  errno = 0;
  stream_.open(written_, std::ios::binary | std::ios::trunc);
  if (!stream_) fail("cannot be written: " + last_error() + "; choose another place");
}

OutputFile::~OutputFile() {
  if (written_ == target_) return;
  stream_.close();
  std::error_code ignored;
  fs::remove(written_, ignored);
}

void OutputFile::write(std::string_view bytes) {
  stream_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void OutputFile::commit() {
  errno = 0;
  stream_.close();
  if (!stream_) fail("cannot be written: " + last_error() + "; free some space");
  if (written_ == target_) return;
  std::error_code error;
  fs::rename(written_, target_, error);
  if (error) fail("cannot be replaced: " + error.message() + "; choose another place");
  written_ = target_;
}

void OutputFile::fail(std::string_view reason) const { throw InputError(path_, {}, reason); }

}  // namespace detent::cli
