#include "rules/driver/stops.h"

#include <algorithm>

#include <fmt/format.h>

#include "analyzer/syntax/known_line.h"
#include "analyzer/syntax/look_alike.h"
#include "rules/driver/behind_stops.h"
#include "rules/driver/ini_places.h"
#include "rules/driver/parameter_helpers.h"
#include "rules/driver/words.h"

namespace owlint::rules {
namespace {

/// Whether an error of reading is about a character that is not ASCII, such as a no-break space.
bool is_about_foreign(const Program& program, const LineError* error, StopKind kind) {
  if (error == nullptr || error->kind != kind) return false;
  const std::string_view text = program.source->slice(error->span);
  return !text.empty() && is_foreign(text[0]);
}

/// Whether what looks like text, or like an O-word behind other words, is a word with a wrong number: `XY5`, `GO X1`, `X1O`.
bool is_about_number(const Program& program, const Statement& s, StopKind kind) {
  if (kind != StopKind::kWordUnreadable && kind != StopKind::kWordBefore) return false;
  const LineError* error = program.syntax.error(s);
  if (error == nullptr || error->kind != kind) return false;
  uint64_t at = 0;
  if (writes_o_for_zero(program, s, *error, &at) || writes_letter_for_one(program, s, *error)) return true;
  // Of two letters, both are probably words.
  const std::string text = small_letters(shown(*program.source, error->span));
  return kind == StopKind::kWordUnreadable && text.size() <= 2 && keyword_of(text) == Keyword::kUnknown;
}

}  // namespace

std::string_view code_of(StopKind kind, const Statement& s) {
  switch (kind) {
    case StopKind::kLineTooLong: return "OW309";
    case StopKind::kCommentNested:
    case StopKind::kCommentUnclosed: return "OW308";
    case StopKind::kLabelMissing:
    case StopKind::kLabelWord:
    case StopKind::kLabelNotInteger:
    case StopKind::kLabelExpression:
    case StopKind::kM98Number:
    case StopKind::kLabelForgotten:
    case StopKind::kLetterForgotten: return "OW306";
    case StopKind::kWordUnreadable:
    case StopKind::kWordUnknown: return "OW701";
    case StopKind::kNumberMissing:
    case StopKind::kNumberMalformed: return "OW702";
    case StopKind::kNumberOutOfRange: return "OW703";
    case StopKind::kWordRepeated: return "OW704";
    case StopKind::kUserCodeMissing:
    case StopKind::kCodeUnknown: return "OW705";
    case StopKind::kCodesConflict: return "OW706";
    case StopKind::kWordUnused: return "OW707";
    case StopKind::kRemapWords:
    case StopKind::kWordMissing: return "OW708";
    case StopKind::kAxisWords: return "OW709";
    case StopKind::kFeedMissing: return "OW801";
    case StopKind::kSpindleStopped: return "OW802";
    case StopKind::kFeedMode: return "OW803";
    case StopKind::kPlaneWrong: return "OW804";
    case StopKind::kCompensation: return "OW805";
    case StopKind::kToolMissing: return "OW806";
    case StopKind::kSavedModes: return "OW807";
    case StopKind::kModeConflict: return "OW808";
    case StopKind::kArcRadiiDiffer: return "OW901";
    case StopKind::kArcRadiusTooSmall: return "OW902";
    case StopKind::kArcWords: return "OW903";
    case StopKind::kCycleWords: return "OW904";
    case StopKind::kCompensationEntry: return "OW905";
    case StopKind::kCompensationGouge: return "OW906";
    case StopKind::kContourWords: return "OW908";
    case StopKind::kM98NoTarget: return "OW208";
    case StopKind::kM98Words:
    case StopKind::kM98Behind:
    case StopKind::kM99Jump:
    case StopKind::kM99Behind:
    case StopKind::kM99Rest: return "OW217";
    case StopKind::kKeywordUnknown: return "OW301";
    case StopKind::kBracketMissing: return "OW302";
    case StopKind::kLineNumber:
    case StopKind::kExpression:
    case StopKind::kParameterRange:
    case StopKind::kValueFails: return "OW303";
    case StopKind::kTrailingText: return "OW304";
    case StopKind::kTooManyArguments: return "OW209";
    case StopKind::kWordBefore: return "OW305";
    case StopKind::kZeroForO: return "OW307";
    case StopKind::kBlockDelete: return "OW313";
    case StopKind::kBadCharacter: return s.kind == LineKind::kPercent ? "OW315" : "OW314";
    case StopKind::kSubNested:
    case StopKind::kSubNestedInCall: return "OW202";
    case StopKind::kReturnOutside:
    case StopKind::kNotInDefinition: return "OW101";
    case StopKind::kLabelUndefined:
      switch (s.keyword) {
        case Keyword::kElse:
        case Keyword::kElseif: return "OW105";
        case Keyword::kBreak:
        case Keyword::kContinue: return "OW107";
        case Keyword::kEndwhile:
        case Keyword::kEndrepeat: return "OW108";
        default: return "OW106";
      }
    case StopKind::kNotAnIf: return "OW106";
    case StopKind::kNotALoop: return "OW107";
    case StopKind::kWrongEnd: return "OW108";
    case StopKind::kDuplicateIf: return "OW104";
    case StopKind::kDuplicateLoop: return s.keyword == Keyword::kRepeat ? "OW102" : "OW103";
    case StopKind::kSubIllegalLocation: return "OW207";
    case StopKind::kSubRedefined: return "OW201";
    case StopKind::kRemapTooDeep:
    case StopKind::kCallTooDeep: return "OW210";
    case StopKind::kSubNotFound: return "OW208";
    case StopKind::kFileLacksSub: return "OW401";
    case StopKind::kFileNameCase: return "OW402";
    case StopKind::kHelperRefused: return "OW403";
    case StopKind::kSubBeforeEntry: return "OW404";
    case StopKind::kFilePercent: return "OW409";
    case StopKind::kFileEnd: return "OW315";
    case StopKind::kStyleNeedsM98:
    case StopKind::kStyleNeedsCall:
    case StopKind::kStyleNeedsM99:
    case StopKind::kStyleNeedsEndsub:
    case StopKind::kFanucDisabled: return "OW211";
    case StopKind::kNameUndefined: return "OW603";
    case StopKind::kNameReadOnly:
    case StopKind::kParameterReadOnly: return "OW604";
    case StopKind::kNone: break;
  }
  return "OW303";
}

std::string_view code_of(const FlowStop& stop, const Program& program) {
  if (stop.statement == kNoStatement) return "OW315";
  const Statement& s = program.at(stop.statement);
  if (stop.kind == StopKind::kFileEnd) {
    // Skipped to the end of the file: by a block that is not closed, or by a jump out of a loop that is over.
    if (s.is(Keyword::kBreak) || s.is(Keyword::kContinue)) return "OW107";
    if (s.is(Keyword::kElse) || s.is(Keyword::kElseif)) return "OW106";
    return s.opens_sub() ? "OW204" : "OW205";
  }
  if (stop.kind == StopKind::kSubIllegalLocation) {
    const Region& region = program.regions[program.region_of[stop.statement]];
    return region.opener == stop.statement && region.enclosing != kNoBlock ? "OW203" : "OW207";
  }
  const bool value = s.is(Keyword::kReturn) || s.is(Keyword::kEndsub);
  if ((stop.kind == StopKind::kValueFails || stop.kind == StopKind::kParameterRange) && value) return "OW512";
  // Carriage returns alone as line ends put a whole file on one line: that is the mistake, whatever it leads to.
  if (s.inner_cr && stop.kind < StopKind::kSubNested) return "OW314";
  if (stop.kind == StopKind::kTrailingText && program.source->slice(s.rest_span()).starts_with("]")) return "OW303";
  if (stop.kind == StopKind::kLineTooLong) return code_of(stop.kind, s);
  if (is_about_foreign(program, stop.further != nullptr ? stop.further : program.syntax.error(s), stop.kind))
    return "OW314";
  if (is_about_number(program, s, stop.kind)) return "OW702";
  return code_of(stop.kind, s);
}

void relate(Finding& finding, const Program& program, StatementId statement, std::string message) {
  if (statement == kNoStatement) return;
  const Statement& s = program.at(statement);
  const Span span = s.kind == LineKind::kOWord || s.calls() || s.runs_remap() ? s.head_span() : s.whole();
  finding.related.push_back({span, std::move(message), nullptr});
}

void relate(const Input& in, Finding& finding, const Elsewhere& place, std::string message) {
  if (place.program == nullptr) return;
  relate(finding, *place.program, place.statement, std::move(message));
  if (place.program != &in.program) finding.related.back().source = place.program->source;
}

Elsewhere place_of(const Input& in, StatementId here, const Elsewhere& elsewhere) {
  if (here == kNoStatement) return elsewhere;
  return {&in.program, here};
}

std::string line_words(const Input& in, const Elsewhere& place) {
  std::string words = "line " + std::to_string(place.program->at(place.statement).line);
  if (place.program != &in.program) words += " of " + file_name(*place.program->source);
  return words;
}

std::string line_end(const Source& source, const Statement& statement) {
  return source.slice(statement.whole()).ends_with('\r') ? "\r\n" : "\n";
}

std::string indent_of(const Source& source, const Statement& statement) {
  const std::string_view line = source.slice(statement.whole());
  return std::string(line.substr(0, std::min(line.find_first_not_of(" \t"), line.size())));
}

Fix split_line(const Program& program, const Statement& statement, uint64_t at, std::string title) {
  const Source& source = *program.source;
  std::string_view before = source.slice({statement.offset, at});
  const uint64_t blanks = statement.offset + before.find_last_not_of(" \t") + 1;
  if (statement.block_delete) before.remove_prefix(before.find('/') + 1);
  const bool good = surely_runs(before) && surely_runs(source.slice({at, statement.end()}));
  const std::string begin =
      line_end(source, statement) + indent_of(source, statement) + (statement.block_delete ? "/" : "");
  return {std::move(title), good, {{{blanks, at}, begin}}, true};
}

StatementId outermost(const Program& program, StatementId statement) {
  const RegionId region = program.region_of[statement];
  if (region != kMainRegion) {
    const Region& sub = program.regions[region];
    if (sub.enclosing == kNoBlock) return sub.opener;
    statement = sub.opener;
  }
  // The blocks of the main program come first, in the order of their openers.
  const auto main_end =
      std::ranges::partition_point(program.blocks, [](const Block& b) { return b.region == kMainRegion; });
  auto at = std::ranges::partition_point(program.blocks.begin(), main_end,
                                         [&](const Block& b) { return b.opener <= statement; });
  if (at == program.blocks.begin()) return statement;
  StatementId outer = statement;
  for (auto block = static_cast<BlockId>(at - program.blocks.begin() - 1); block != kNoBlock;
       block = program.blocks[block].parent) {
    const Block& b = program.blocks[block];
    if (b.end != kNoStatement && b.end >= statement) outer = b.opener;
  }
  return outer;
}

Fix move_up(const Program& program, StatementId first, StatementId last, StatementId before, std::string title) {
  const Source& source = *program.source;
  const uint64_t begin = program.at(first).offset;
  const uint64_t end = std::min<uint64_t>(program.at(last).end() + 1, source.bytes().size());
  std::string lines(source.slice({begin, end}));
  if (!lines.ends_with('\n')) lines += line_end(source, program.at(first));
  const uint64_t to = program.at(before).offset;
  return {std::move(title), false, {{{to, to}, std::move(lines)}, {{begin, end}, ""}}};
}

bool bounds_sub(const Statement& statement) { return statement.opens_sub() || statement.is(Keyword::kEndsub); }

std::string file_name(const Source& source) { return std::string(name_of(source.path())); }

/// The call in which it stops, if that matters: others of the same sub may pass values for which it does not stop.
StatementId telling_call(const Program& program, const FlowStop& stop) {
  if (stop.call == kNoStatement || stop.statement == kNoStatement) return kNoStatement;
  if (stop.kind < StopKind::kNameUndefined && program.at(stop.statement).label_expr == kNoExpr) return kNoStatement;
  const NameId sub = program.regions[program.region_of[stop.statement]].name;
  if (sub == kNoName) return kNoStatement;
  int calls = 0;
  const bool several = std::ranges::any_of(
      program.by_label[sub], [&](StatementId id) { return program.at(id).is(Keyword::kCall) && ++calls > 1; });
  return several ? stop.call : kNoStatement;
}

void describe_stop(const Input& in, const FlowStop& stop, Finding& finding) {
  finding.further = stop.further != nullptr;
  finding.reach = stop.reach;
  finding.stops = !finding.further && stop.reach != Reach::kNever;
  if (stop.reach == Reach::kNever) finding.group = group_behind(finding, stop);  // not with those of real ones
  finding.unproven = finding.unproven || (stop.unproven && !finding.help.starts_with("write `"));
  const bool known = stop.kind == StopKind::kUserCodeMissing || !finding.interpreter.empty();  // by the rule
  if (!known) finding.interpreter = stop.interpreter;
  for (const Decision& decision : stop.path) {
    const Elsewhere place{decision.program == nullptr ? &in.program : decision.program, decision.statement};
    const Statement& s = place.program->at(decision.statement);
    const bool repeat = s.is(Keyword::kRepeat);
    const char* const outcome =
        decision.taken ? (repeat ? " repeats" : " is true") : (repeat ? " does not repeat" : " is false");
    finding.path.push_back(
        {s.head_span(), "when `" + place.program->head(decision.statement) + "` on " + line_words(in, place) + outcome,
         decision.program == nullptr ? nullptr : decision.program->source});
  }
  tell_new_machine(in, stop, finding);
  if (finding.further) relate_first_mistake(in, stop, finding);
  relate(in, finding, stop.call_elsewhere, "called here");
  relate(finding, in.program, telling_call(in.program, stop), "called here");
  relate_unused_remap(in, stop, finding);
  if (finding.stops) add_consequences(in, stop.statement, finding);
}

void add_consequences(const Input& in, StatementId statement, Finding& finding) {
  const auto [first, last] = in.index.consequences.equal_range(statement);
  for (auto it = first; it != last; ++it) {
    const FlowStop& other = *it->second;
    const Span span = other.statement == kNoStatement ? finding.span : in.program.at(other.statement).head_span();
    finding.consequences.push_back({code_of(other, in.program), span, other.interpreter});
  }
}

namespace {

template <typename Lists>
auto list_of(const Lists& lists, const Reporter& out) {
  const auto found = lists.find(out.rule().code);
  return found == lists.end() ? std::span<const typename Lists::mapped_type::value_type>() : std::span(found->second);
}

}  // namespace

std::span<const FlowStop* const> stops_of(const Input& in, const Reporter& out) {
  return list_of(in.index.by_code, out);
}

std::span<const Hazard* const> warned_of(const Input& in, const Reporter& out) {
  return list_of(in.index.warned_by_code, out);
}

std::span<const StatementId> unmet_of(const Input& in, const Reporter& out) {
  return list_of(in.index.unmet_by_code, out);
}

std::optional<FlowStop> as_stop(const Input& in, const Reporter& out, const Hazard& warned) {
  if (std::ranges::any_of(stops_of(in, out), [&](const FlowStop* stop) { return stop->statement == warned.statement; }))
    return std::nullopt;
  FlowStop stop;
  stop.statement = warned.statement;
  stop.kind = warned.warned;
  stop.other = warned.other;
  return stop;
}

bool has_stop(const Input& in, StatementId statement) {
  return statement < in.index.at.size() && in.index.at[statement];
}

std::string look_alike_text(std::string_view text) {
  const char32_t code = character_at(text).code;
  const LookAlike same = look_alike(code).value();
  const std::string who = fmt::format("the character U+{:04X} {}", static_cast<uint32_t>(code), same.name);
  if (same.plain.empty()) return who + " is here; most editors do not show it";
  std::string plain(same.plain);  // ` GE ` without its blanks
  if (plain.size() > 2 && plain.starts_with(' ')) plain = plain.substr(1, plain.size() - 2);
  return who +
      (same.plain == " " ? " looks like a space, but is not one"
                         : " looks like `" + plain + "`, but is another character");
}

std::string look_alike_name(const Input& in, std::string_view name) {
  const Names& names = in.program.syntax.names;
  // A letter such as `ä` is no ASCII character, either, and looks like no other.
  const auto differs = [](std::string_view foreign) {
    while (!is_foreign(foreign[0]) || !look_alike(character_at(foreign).code))
      foreign.remove_prefix(character_at(foreign).length);
    return look_alike_text(foreign);
  };
  const std::string plain = plain_text(name);
  const bool known = plain != name && (names.find(plain) != kNoName || in.linked.search_path().find(plain));
  if (plain != name)
    return !known ? std::string() : "in `<" + std::string(name) + ">` " + differs(name) + ": write `<" + plain + ">`";
  for (const NameId id : in.index.foreign_names) {
    if (names.text(id) != name && plain_text(names.text(id)) == name)
      return "in `<" + names.text(id) + ">` " + differs(names.text(id)) + ": write `<" + plain + ">`";
  }
  return {};
}

std::string misread_words(const Program& program, StatementId line) {
  const Statement& s = program.at(line);
  const std::string where = "line " + std::to_string(s.line);
  if (s.name_open) return "the name on " + where + " has no `>`";
  if (!s.has_error()) return "`" + program.label_at(line) + "` on " + where + " has no keyword";
  if (s.kind == LineKind::kWords && s.keyword != Keyword::kUnknown)
    return "`" + std::string(spelling(s.keyword)) + "` on " + where + " has no label";
  const std::string meant(spelling(meant_by(program, line).keyword));
  return "LinuxCNC does not read " + where + " as " + (meant.empty() ? "its end" : "`" + meant + "`");
}

void name_misread(const Program& program, StatementId line, const std::string& right, Finding& finding) {
  const Statement& s = program.at(line);
  Meant meant = meant_by(program, line);
  if (meant.keyword == Keyword::kUnknown) meant.words = s.head_span();
  finding.related.push_back({meant.words, "this is probably meant to be `" + right + "`", nullptr});
  const std::string_view before = program.source->slice({s.offset, meant.words.begin});
  finding.help = "write `" + right + "` on line " + std::to_string(s.line);
  const bool first = before.find_first_not_of(" \t") == std::string_view::npos;
  if (const LineError* error = program.syntax.error(s); error != nullptr && error->kind == StopKind::kWordBefore)
    finding.help = "put `" + right + "` of line " + std::to_string(s.line) + " on a line of its own";
  else if (first && program.source->slice(meant.words) != right)
    finding.fixes.push_back({"write `" + right + "`", false, {{meant.words, right}}, true});
}

std::string ordinal(size_t n) {
  const bool teens = n % 100 / 10 == 1;
  const char* const ending = teens ? "th" : n % 10 == 1 ? "st" : n % 10 == 2 ? "nd" : n % 10 == 3 ? "rd" : "th";
  return std::to_string(n) + ending;
}

}  // namespace owlint::rules
