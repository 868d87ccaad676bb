// Any line is an expression or an error with a place on that line.
#include <cstdlib>

#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/line_parser.h"

using namespace owlint;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size > kLineLimit) return 0;
  LineText line;
  if (line.assign({reinterpret_cast<const char*>(data), size}, 0) != StopKind::kNone) return 0;
  ExprPool pool;
  Names names;
  ExpressionParser parser(line, pool, names);
  const ExprId id = line[0] == '[' ? parser.bracketed() : parser.value();
  if (parser.cursor > line.size()) std::abort();
  if (id == kNoExpr) {
    const Span span = line.span(parser.error().from, parser.error().to);
    if (parser.error().message.empty() || span.begin > span.end || span.end > size) std::abort();
    return 0;
  }
  for (ExprId i = 0; i < pool.size(); ++i) {
    if ((pool[i].left() != kNoExpr && pool[i].left() >= i) || (pool[i].right() != kNoExpr && pool[i].right() >= i))
      std::abort();
  }
  double value = 0;
  long number = 0;
  if (literal_value(pool, id, &value)) to_integer(value, &number);
  return 0;
}
