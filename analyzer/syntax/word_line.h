// The words of one line, as the interpreter sees them before it does anything: which may stand together, which code
// uses them, and which error comes first. The line parser fills it word by word, the flow asks it for each mode that
// may be in effect. O-word lines do not come here.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analyzer/syntax/codes.h"
#include "analyzer/syntax/stop.h"

namespace owlint {

/// The modes before a line that decide whether it is good. A concrete motion: callers go through those that may be.
struct Modes {
  enum Distance : uint8_t { kDistanceUnknown, kAbsolute, kIncremental };
  enum Plane : uint8_t { kPlaneUnknown, kG17, kOtherPlane };

  Motion motion = Motion::kG80;
  Distance distance = kDistanceUnknown;
  Plane plane = kPlaneUnknown;
};

struct Word {
  char letter;  ///< small
  bool known;   ///< false for a computed value that is not known
  double value;
  uint8_t from, to;  ///< bytes of the line
};

inline constexpr uint8_t kNoWord = 255;

/// A word that the machine's INI remaps.
struct RemappedWord {
  const RemappedCode* code;
  uint8_t word;
};

struct Fault {
  StopKind kind;
  std::string message;  ///< the interpreter's
  uint8_t word;   ///< index of the word it is about, or of the code that wants one; kNoWord: that is a modal motion
  uint8_t other;  ///< index of another word concerned, such as the first of two conflicting codes, or kNoWord
  bool certain;   ///< false if it depends on a value or a mode that is not known
};

/// Faults that a mode decides: check() leaves them open if it is not told the mode.
inline constexpr const char* kPolarOutsideG17 = "Cannot use polar coordinate except in G17 plane";
inline constexpr const char* kIncrementalG53 = "Cannot use g53 incremental";

class WordLine {
 public:
  explicit WordLine(const MachineWords& machine) : machine_(&machine) {}
  /// Takes up another line.
  void clear();
  /// The line begins with M98: all its other words are read and checked, and none but P and L has an effect. M98 is not
  /// counted as an M word (measured).
  void begin_call();

  /// Before a word's value is read, of a letter that begins one (word_row). The word the fault is about has the index
  /// size().
  std::optional<Fault> letter(char letter) const;
  /// After its value was read. Behind a fault that is certain nothing more is asked of the line. A value that is not
  /// known is taken for a good one, and a code that is not known for one that changes nothing, but then faults of
  /// check() are not certain.
  std::optional<Fault> add(const Word& word);

  /// What the complete line stops with: the first fault that is certain, else the first possible one. `*after` gets the
  /// modes that may be in effect behind the line if it runs.
  std::optional<Fault> check(const Modes& before, MotionSet* after = nullptr) const;
  /// False if the line's own codes decide: then check() says the same whatever the motion before.
  bool depends_on_motion() const;
  /// What the line moves by if `mode` is in effect.
  Motion motion(Motion mode) const;
  /// The modes behind the line for each of those before.
  MotionSet after(MotionSet before) const;

  size_t size() const { return size_; }
  const Word& operator[](size_t index) const { return words_[index]; }
  /// The index of a letter's word, the last one if it may be repeated; kNoWord without one.
  uint8_t find(char letter) const;
  bool has(char letter) const { return find(letter) != kNoWord; }
  bool has_axis_words() const { return (letters_ & kAxisLetters) != 0; }
  bool has_polar_words() const { return (letters_ & kPolarLetters) != 0; }
  /// The code of a group on the line, or null; remapped codes aside.
  const GCode* code(GGroup group) const { return g_[static_cast<size_t>(group)].code; }
  const MCode* code(MGroup group) const { return m_[static_cast<size_t>(group)].code; }
  /// The index of its word, also of a remapped code; kNoWord if the line has none of the group.
  uint8_t word_of(GGroup group) const { return g_[static_cast<size_t>(group)].word; }
  uint8_t word_of(MGroup group) const { return m_[static_cast<size_t>(group)].word; }
  /// M100 to M199: known to every machine, but a program of its own must be there for it.
  bool is_user_m() const { return code(MGroup::kUser) != nullptr; }
  /// A code that the machine defines is on the line, or may be: what it does is for its sub or its Python to say.
  bool has_remapped_code() const { return remapped_m_ || code_ == Motion::kRemapped || remapped_letters_ != 0; }
  /// Whether the words of a letter are remapped: T, S and F, which have no effect of their own then.
  bool is_remapped(char letter) const { return (remapped_letters_ & letter_set({&letter, 1})) != 0; }
  /// Whether the line moves by a remapped G code.
  bool moves_by_remap() const { return code_ == Motion::kRemapped; }
  /// The remapped codes of the line, in the order in which they act.
  std::vector<RemappedWord> remapped_words() const;
  /// Whether a REMAP line has taken the M code away from its meaning.
  bool loses_m(int32_t number) const { return lost('m', number) != nullptr; }
  /// A G or M word whose value is not known.
  bool has_unknown_code() const { return unknown_code_; }

 private:
  class Outcome;
  template <typename Code>
  struct Place {
    const Code* code = nullptr;
    uint8_t word = kNoWord;
  };

  std::optional<Fault> add_g(int32_t tenths, uint8_t at);
  std::optional<Fault> add_m(int32_t number, uint8_t at);
  std::optional<Fault> range(const Word& word, uint8_t at, int32_t* whole) const;
  std::optional<Fault> add_lost_m(const LostCode& lost, uint8_t at);
  /// What a code that a REMAP line has taken away stops with, behind all other checks of the line.
  std::optional<Fault> lost_fault() const;
  const LostCode* lost(char letter, int32_t number) const;
  const RemappedCode* remapped(char letter, int32_t number) const;
  const RemappedCode* remapped(const Word& word) const;

  /// The stages of check(); true if the line certainly stops.
  bool axis_words(const Modes& before, Outcome& out) const;
  bool polar_words(const Modes& before, Outcome& out) const;
  bool non_modal(const Modes& before, Outcome& out) const;
  bool g10(Outcome& out) const;
  bool other_words(Motion motion, Outcome& out) const;
  bool fails(const LineCheck& check, const CodeSet& line, Outcome& out) const;
  bool fails_value(const LineCheck& check) const;

  bool has_code(GGroup group, int tenths) const;
  /// Whether G10, G28, G30, G52 or G92 takes the axis words.
  bool has_taker() const;
  /// The letters among these that count as given: P-1 and Q-1 mean that there is none.
  uint32_t given(uint32_t letters) const;
  uint8_t first_word(uint32_t letters) const;
  uint8_t word_of(const CodeSet& codes) const;

  // A line has 253 bytes, and a word at least two.
  static constexpr size_t kMaxWords = 127;

  const MachineWords* machine_;
  uint8_t size_ = 0;
  uint8_t m_words_ = 0;
  uint8_t fifth_m_ = kNoWord;
  bool unknown_code_ = false;
  bool remapped_m_ = false;
  bool call_ = false;
  uint8_t lost_g_ = kNoWord, lost_user_ = kNoWord, lost_stop_ = kNoWord;  // words of such codes
  uint32_t remapped_letters_ = 0;
  Motion code_ = Motion::kNone;  ///< the motion that the line itself has
  uint32_t letters_ = 0;
  CodeSet codes_;  ///< but for the motion
  std::array<Place<GCode>, kGGroups> g_{};
  std::array<Place<MCode>, kMGroups> m_{};
  std::array<uint8_t, kLetters> at_;   // by letter, where letters_ has it
  std::array<Word, kMaxWords> words_;  // those before size_
};

}  // namespace owlint
