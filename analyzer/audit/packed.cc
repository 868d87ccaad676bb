#include "analyzer/audit/packed.h"

extern "C" {
#include <b64/cencode.h>
}
#include <zlib.h>

#include <stdexcept>

namespace owlint::audit {
namespace {

std::string gzip(std::string_view text) {
  constexpr int kLevel = 6;
  constexpr int kGzip = 15 + 16;  // the largest window, with gzip's header
  z_stream stream{};
  if (::deflateInit2(&stream, kLevel, Z_DEFLATED, kGzip, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("zlib does not start");
  std::string out(::deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int end = ::deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  ::deflateEnd(&stream);
  if (end != Z_STREAM_END) throw std::runtime_error("zlib does not come to an end");
  return out;
}

}  // namespace

std::string packed(std::string_view text) {
  const std::string bytes = gzip(text);
  std::string out(bytes.size() * 2 + 16, '\0');  // room for the line ends that libb64 makes
  base64_encodestate state;
  ::base64_init_encodestate(&state);
  int length = ::base64_encode_block(bytes.data(), static_cast<int>(bytes.size()), out.data(), &state);
  length += ::base64_encode_blockend(out.data() + length, &state);
  out.resize(static_cast<size_t>(length));
  return out;
}

}  // namespace owlint::audit
