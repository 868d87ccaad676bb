// What a line becomes in the Syntax when modes matter: a question to the flow, and the calls of its remapped codes.
#include <algorithm>

#include "analyzer/syntax/mode_line.h"
#include "analyzer/syntax/modes_in_effect.h"
#include "analyzer/syntax/remaps.h"

namespace owlint {

Statement ModesInEffect::question_of(const Statement& statement) {
  const WordLine& words = parser_.words() != nullptr ? *parser_.words() : *parser_.words_of_call();
  Statement asks = question_about(statement, LineKind::kModeLine, static_cast<uint32_t>(out_.mode_words.size()));
  asks.item_count = static_cast<uint8_t>(words.size());
  asks.for_place = asks_place_;
  // Words that are computed have an item each, in the order of the line.
  const auto items = out_.items_of(statement);
  auto item = items.begin();
  for (size_t i = 0; i < words.size(); ++i) {
    const Word& word = words[i];
    ModeWord out{word.value, kNoExpr, word.letter, word.from, word.to, word.known};
    if (!word.known) {
      item = std::find_if(item, items.end(), [&](const Item& it) { return it.letter != 0; });
      if (item != items.end()) out.computed = (item++)->value;
      if ((letter_set({&word.letter, 1}) & machine_.wrapped) != 0) out_.asks_place = true;
    }
    out_.mode_words.push_back(out);
  }
  return asks;
}

/// Whether a curve of G5.2 begins, goes on or is dropped at a line. Where it is open which motion is in effect, none is said to
/// be dropped.
void ModesInEffect::follow_curve(const WordLine& words, const ModeSets& after, const Statement& statement) {
  const GCode* const code = words.code(GGroup::kNonModal);
  const bool ended = code != nullptr && code->tenths == code::kG5_3;
  const bool ends = ends_program(statement);
  const bool open = after.is_open(Mode::kMotion);
  const MotionSet motions = after[Mode::kMotion];
  const bool points = after[Mode::kNurbs] != value_bit(modes::kNoPoints);
  const bool goes_on = motions == set_of(Motion::kG5_2) && !open && points && !ends && !stopped_;
  if (ended) {
    curve_ = {};
  } else if (ends || (!stopped_ && !open && (!contains(motions, Motion::kG5_2) || !points))) {
    drop_curve(statement.line);
  }
  if (!goes_on) {
    curve_ = {};
  } else if (curve_.line == 0) {
    const auto last = static_cast<StatementId>(out_.statements.size() - 1);
    curve_ = {out_.statements.empty() ? kNoStatement : last, statement.line, 0};
  }
}

/// The curve that goes on, if there is one, is over without its end.
void ModesInEffect::drop_curve(uint32_t line) {
  if (curve_.line == 0) return;
  curve_.dropped = line;
  out_.dropped_curves.push_back(curve_);
  curve_ = {};
}

/// Behind the line's own statement: what each of its remapped codes runs, and the question about what comes then.
void ModesInEffect::push_remaps(const Statement& statement, const Statement& asks) {
  for (const RemappedWord& remap : remaps_) {
    const ModeWord& word = out_.mode_words[asks.first + remap.word];
    Statement runs = question_about(statement, LineKind::kRemap, asks.first);
    runs.item_count = asks.item_count;
    if (!remap.code->sub.empty()) runs.label = out_.names.intern(small_letters(remap.code->sub));
    runs.label_from = runs.keyword_from = word.from;
    runs.label_to = runs.keyword_to = word.to;
    out_.statements.push_back(runs);
    out_.statements.push_back(asks);
  }
}

bool ModesInEffect::has_own(const Statement& statement) {
  return statement.kind != LineKind::kWords || statement.item_count > 0 || statement.has_error();
}

void ModesInEffect::push(const Statement& statement) {
  if (!asks_place_) flush();
  const bool asks = asks_ && statement.kind != LineKind::kAbort;
  const bool remaps = asks && !remaps_.empty();
  const Statement question = asks ? question_of(statement) : Statement{};
  if (asks) out_.statements.push_back(question);
  if (remaps && ends_program(statement)) push_remaps(statement, question);
  if (has_own(statement) || !asks_) out_.statements.push_back(statement);
  if (remaps && !ends_program(statement)) push_remaps(statement, question);
}

/// Whether plain lines may be holes of a cycle with depths of their own, each of which is compared with `R`.
bool ModesInEffect::drills_deep(const PlainEffect& effect) const {
  const ModeSets& now = state_.now;
  if (!effect.alone || now.is_open(Mode::kMotion) || (now[Mode::kMotion] & kCycles) == 0) return false;
  const auto along = [&](modes::Plane plane, char axis) {
    return (now[Mode::kPlane] & value_bit(plane)) != 0 && (effect.axes & letter_set({&axis, 1})) != 0;
  };
  return along(modes::kG17, 'z') || along(modes::kG18, 'y') || along(modes::kG19, 'x');
}

}  // namespace owlint
