// Completion: keywords that fit after a label, the end of the innermost open block, subs that can be called, a number
// that nobody uses. On other lines: codes, in code_completion.cc.
#include <algorithm>

#include "analyzer/lsp/features.h"
#include "analyzer/lsp/keywords.h"
#include "analyzer/lsp/places.h"
#include "analyzer/lsp/word_help.h"
#include "analyzer/text/characters.h"

namespace owlint::lsp {
namespace {

enum Kind { kFunction = 3, kValue = 12, kKeyword = 14, kSnippet = 15 };

Json item(const Document& document, const std::string& label, Kind kind, const std::string& text, Span replaced,
          const std::string& detail) {
  Json out{{"label", label},
           {"kind", static_cast<int>(kind)},
           {"textEdit", {{"range", document.range(replaced)}, {"newText", text}}}};
  if (!detail.empty()) out["detail"] = detail;
  return out;
}

/// Blocks that are open before a line, innermost last. What is closed further down counts as open in between.
std::vector<BlockId> open_blocks(const Program& p, uint64_t offset, RegionId region) {
  std::vector<BlockId> open;
  for (BlockId id = 0; id < p.blocks.size(); ++id) {
    const Block& b = p.blocks[id];
    if (b.region != region || p.at(b.opener).offset >= offset) continue;
    if (b.end == kNoStatement || p.at(b.end).offset >= offset) open.push_back(id);
  }
  return open;
}

std::string end_line(const Program& p, const Block& b) {
  return label_text(p.name(b.label)) + " " + std::string(spelling(end_of(b.kind))) +
      (b.kind == Keyword::kDo ? " []" : "");
}

std::string fresh_number(const Program& p) {
  for (uint32_t number = 100; number < 100'000; number += 10) {
    const NameId id = p.syntax.names.find(std::to_string(number));
    if (id == kNoName || id >= p.by_label.size() || p.by_label[id].empty()) return std::to_string(number);
  }
  return {};
}

class Completion {
 public:
  Completion(Workspace& workspace, const Document& document, uint64_t offset)
      : workspace_(workspace),
        document_(document),
        program_(document.program()),
        offset_(offset),
        line_(document.line_at(offset)),
        region_(region_at(document, line_.begin)),
        before_(std::string_view(document.text()).substr(line_.begin, offset - line_.begin)) {}

  Json run() {
    size_t at = 0;
    while (at < before_.size() && is_space_or_tab(before_[at])) ++at;
    if (at < before_.size() && (before_[at] | 0x20) == 'n') {
      for (++at; at < before_.size() &&
           (is_space_or_tab(before_[at]) || std::isdigit(static_cast<unsigned char>(before_[at])) != 0);)
        ++at;
    }
    if (at == before_.size()) {
      line_start(at);
      return std::move(out_);
    }
    if ((before_[at] | 0x20) != 'o') return code_completion(document_, workspace_.profile_of(document_), offset_);
    const size_t label = at++;
    while (at < before_.size() && is_space_or_tab(before_[at])) ++at;
    if (at < before_.size() && before_[at] == '<') {
      const size_t close = before_.find('>', at);
      if (close == std::string_view::npos) {
        names(label);
        return std::move(out_);
      }
      at = close + 1;
    } else {
      while (at < before_.size() && std::isdigit(static_cast<unsigned char>(before_[at])) != 0) ++at;
    }
    if (at == before_.size()) {
      labels(label);
      return std::move(out_);
    }
    const std::string name = normalised(before_.substr(label, at - label));
    while (at < before_.size() && is_space_or_tab(before_[at])) ++at;
    const size_t typed = at;
    while (at < before_.size() && is_letter(before_[at])) ++at;
    if (at == before_.size()) keywords(name, typed);
    return std::move(out_);
  }

 private:
  Span from(size_t begin) const { return {line_.begin + begin, offset_}; }

  static std::string normalised(std::string_view label) {
    std::string out;
    for (const char c : label.substr(1)) {
      if (!is_space_or_tab(c) && c != '<' && c != '>') out.push_back(c);
    }
    return small_letters(out);
  }

  void innermost_end(size_t begin) {
    const std::vector<BlockId> open = open_blocks(program_, line_.begin, region_);
    if (open.empty()) return;
    const Block& b = program_.blocks[open.back()];
    const std::string text = end_line(program_, b);
    Json end = item(document_, text, kSnippet, text, from(begin),
                    "ends `" + program_.head_of(b) + "` on line " + std::to_string(program_.at(b.opener).line));
    end["sortText"] = "0";
    end["preselect"] = true;
    out_.push_back(std::move(end));
  }

  void line_start(size_t begin) {
    innermost_end(begin);
    labels(begin);
  }

  /// At an `o`, or before one: the end that is due, a number that is free, subs.
  void labels(size_t begin) {
    if (begin < before_.size()) innermost_end(begin);
    if (const std::string number = fresh_number(program_); !number.empty()) {
      out_.push_back(item(document_, "o" + number, kValue, "o" + number, from(begin), "a number that no O-word uses"));
    }
    subs(begin);
  }

  void names(size_t begin) { subs(begin); }

  void subs(size_t begin) {
    constexpr size_t kMost = 500;
    // Text that is already after the cursor is replaced, or not written again.
    std::string_view rest = std::string_view(document_.text()).substr(offset_, line_.end - offset_);
    Span replaced = from(begin);
    if (rest.starts_with(">")) {
      ++replaced.end;
      rest.remove_prefix(1);
    }
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    const std::string call = keyword_of(small_letters(rest.substr(0, 8))) == Keyword::kUnknown ? " call" : "";
    std::set<std::string> known;
    const auto add = [&](const std::string& name, const std::string& where) {
      if (out_.size() >= kMost || !known.insert(name).second) return;
      out_.push_back(item(document_, label_text(name) + call, kFunction, label_text(name) + call, replaced, where));
    };
    for (const Region& r : program_.regions) {
      if (r.opener != kNoStatement) add(program_.name(r.name), "line " + std::to_string(program_.at(r.opener).line));
    }
    for (const std::string& name : workspace_.callable_files(document_)) {
      if (out_.size() >= kMost) break;
      const Document* file =
          known.contains(name) ? nullptr : workspace_.document_of_path(workspace_.called_file(document_, name));
      if (file != nullptr && defines_own_name(file->program())) add(name, name + ".ngc");
    }
  }

  void keywords(const std::string& name, size_t begin) {
    const NameId id = program_.syntax.names.find(name);
    std::vector<Keyword> fitting;
    for (const BlockId open : open_blocks(program_, line_.begin, region_)) {
      const Block& b = program_.blocks[open];
      if (b.label != id) continue;
      fitting.push_back(end_of(b.kind));
      if (b.kind == Keyword::kIf) fitting.insert(fitting.end(), {Keyword::kElseif, Keyword::kElse});
      if (b.kind == Keyword::kWhile || b.kind == Keyword::kDo)
        fitting.insert(fitting.end(), {Keyword::kBreak, Keyword::kContinue});
    }
    if (region_ != kMainRegion && program_.regions[region_].name == id && id != kNoName)
      fitting.insert(fitting.end(), {Keyword::kReturn, Keyword::kEndsub});
    if (fitting.empty()) {
      fitting = {Keyword::kIf, Keyword::kWhile, Keyword::kDo, Keyword::kRepeat, Keyword::kCall};
      if (region_ == kMainRegion) fitting.push_back(Keyword::kSub);
      if (region_ != kMainRegion) fitting.push_back(Keyword::kReturn);
    }
    for (const Keyword k : fitting) {
      const std::string word(spelling(k));
      const bool condition =
          k == Keyword::kIf || k == Keyword::kElseif || k == Keyword::kWhile || k == Keyword::kRepeat;
      Json keyword =
          item(document_, word, kKeyword, condition ? word + " []" : word, from(begin), std::string(meaning(k)));
      keyword["filterText"] = word;
      out_.push_back(std::move(keyword));
    }
  }

  Workspace& workspace_;
  const Document& document_;
  const Program& program_;
  uint64_t offset_;
  Span line_;
  RegionId region_;
  std::string_view before_;
  Json out_ = Json::array();
};

}  // namespace

Json completion(Workspace& workspace, const Json& params) {
  const auto [document, offset] = place_of(workspace, params);
  return {{"isIncomplete", false}, {"items", Completion(workspace, document, offset).run()}};
}

}  // namespace owlint::lsp
