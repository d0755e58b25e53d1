// SPDX-License-Identifier: MIT
#include "gzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "error.hpp"

namespace detent::cli {
namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 30;

/// zlib's state for reading gzip files (RFC 1952).
class Inflater {
 public:
  Inflater() {
    if (inflateInit2(&stream_, 16 + MAX_WBITS) != Z_OK) {
      throw InputError("zlib cannot start; free some memory");
    }
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  z_stream& operator*() { return stream_; }

 private:
  z_stream stream_{};
};

}  // namespace

std::string unpacked(const std::string& path, std::string bytes) {
  if (!bytes.starts_with("\x1f\x8b")) return bytes;
  Inflater inflater;
  z_stream& stream = *inflater;
  std::vector<Bytef> buffer(1 << 16);
  std::string content;
  std::size_t taken = 0;
  while (true) {
    // zlib counts in 32 bits, and takes a non-const pointer although it does not write.
    const std::size_t part = std::min<std::size_t>(bytes.size() - taken, 1 << 20);
    stream.next_in = reinterpret_cast<Bytef*>(bytes.data() + taken);
    stream.avail_in = static_cast<uInt>(part);
    stream.next_out = buffer.data();
    stream.avail_out = static_cast<uInt>(buffer.size());
    const int status = inflate(&stream, Z_NO_FLUSH);
    taken += part - stream.avail_in;
    const std::size_t size = buffer.size() - stream.avail_out;
    content.append(reinterpret_cast<const char*>(buffer.data()), size);
    if (content.size() > most_bytes) {
      throw InputError(path, {}, "holds more than 1 GiB; split it");
    }
    if (status == Z_STREAM_END) {
      if (taken == bytes.size()) return content;
      inflateReset(&stream);  // concatenated gzip files are one file
    } else if (status != Z_OK || (taken == bytes.size() && size == 0)) {
      throw InputError(path, {}, "a damaged or truncated gzip file; copy it again");
    }
  }
}

}  // namespace detent::cli
