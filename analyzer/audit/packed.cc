#include "analyzer/audit/packed.h"

#include <zlib.h>

#include <stdexcept>

#include "analyzer/text/base64.h"

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

std::string packed(std::string_view text) { return base64(gzip(text)); }

}  // namespace owlint::audit
