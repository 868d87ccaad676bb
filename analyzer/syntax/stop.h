// Why the interpreter stops at a line. A kind stands for one message of LinuxCNC, or for some that mean the same. code_of() says
// which rule reports it (rules/driver/stops.cc); for a few kinds that depends on the line, too.
//
// The scanner and the parser find the first two groups; what a computed value decides, the flow finds. The third is found where
// lines are carried out: what modes and the place refuse in mode_*.cc, all else in the flow. Some code compares kinds by their
// order, so a new kind goes into its group.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace owlint {

enum class StopKind : uint8_t {
  kNone,
  // Found while a line is read, also while lines are skipped.
  kLineTooLong,
  kCommentNested,
  kCommentUnclosed,
  kLineNumber,       // N without digits
  kLabelMissing,     // `o` with no number
  kLabelWord,        // `o sub`: a word where the number should be
  kLabelNotInteger,  // `o1.5`
  kLabelExpression,  // malformed or failing `o[...]`
  kM98NoTarget,
  kM98Number,
  kM98Words,        // a word twice, or an L that is negative or not whole
  kKeywordUnknown,  // not while a definition is skipped
  // Found while a line is read that is not skipped.
  kBracketMissing,
  kExpression,
  kTrailingText,
  kTooManyArguments,
  kWordBefore,
  kZeroForO,
  kLabelForgotten,   // `if [1]` without `o100`
  kLetterForgotten,  // `100 if [1]`, `<name> call`: without the `o`
  kWordUnreadable,   // a letter without a value: `GOTO 20`, `hello`
  kWordUnknown,      // `U1` on a machine without that axis
  kNumberMissing,    // `G1 X`
  kNumberMalformed,  // `X1..2`, `F--5`
  kNumberOutOfRange,
  kWordRepeated,
  kCodeUnknown,
  kCodesConflict,
  kWordUnused,
  kWordMissing,
  kAxisWords,
  kBlockDelete,
  kBadCharacter,
  kM98Behind,  // M98 that is not the line's first word
  kM99Jump,    // `M99 P…` in the main program
  // Found while a line is executed.
  kFeedMissing,        // a feed move with feed 0
  kSpindleStopped,     // a move that needs a turning spindle, or a speed
  kFeedMode,           // what G93 or G95 forbids
  kPlaneWrong,         // what the plane in effect does not take
  kCompensation,       // what cutter compensation forbids, or what it needs to begin
  kToolMissing,        // a tool or offset that the table lacks
  kSavedModes,         // M72 without M70, or one that cannot restore
  kModeConflict,       // anything else that the modes in effect refuse
  kArcWords,           // words of an arc that do not make one
  kArcRadiiDiffer,     // an arc whose ends are not as far from its center
  kArcRadiusTooSmall,  // an arc whose radius does not reach its end
  kCompensationEntry,  // a first move with compensation that is not longer than the tool's radius
  kCompensationGouge,  // a corner or an arc that the compensated tool does not fit into
  kCycleWords,         // words of a cycle that do not make one
  kContourWords,       // words of a contour, a spline or a thread that do not make one
  kUserCodeMissing,    // `M110`: no file of that name, as far as is known
  kRemapWords,         // words that a remapped code passes to its sub
  kRemapTooDeep,       // remapped codes in the subs of remapped codes
  kM99Behind,          // M99 that is not the line's first word, in a sub
  kM99Rest,            // words behind M99, in a sub
  kSubNested,
  kSubNestedInCall,  // LinuxCNC 2.10: a definition within a called sub
  kReturnOutside,
  kNotInDefinition,
  kLabelUndefined,
  kNotAnIf,
  kNotALoop,
  kWrongEnd,
  kDuplicateIf,
  kDuplicateLoop,
  kSubIllegalLocation,
  kSubRedefined,
  kCallTooDeep,
  kSubNotFound,     // end of file while a call looks for its sub
  kFileNameCase,    // a call finds no sub, but there is a file of its name in capital letters
  kFileLacksSub,    // a called file ends, and the sub was not in it
  kFilePercent,     // a called file is over at a `%`, and the sub was not in it
  kSubBeforeEntry,  // in a called file, a call of a sub that is before the one that was called
  kHelperRefused,   // LinuxCNC 2.10: a call of another sub in a called file
  kFileEnd,         // end of file in the program itself, or while lines are skipped
  kStyleNeedsM98,
  kStyleNeedsCall,
  kStyleNeedsM99,
  kStyleNeedsEndsub,
  kFanucDisabled,  // DISABLE_FANUC_STYLE_SUB
  kNameUndefined,
  kNameReadOnly,
  kParameterReadOnly,
  kParameterRange,
  kValueFails,  // division by zero, root of a negative number, ...
};

/// Whether words stop with it when they are carried out, in the modes and at the place in effect. In the sub of a contour no line
/// does, for such lines are only read.
constexpr bool is_of_modes_or_place(StopKind kind) {
  return kind >= StopKind::kFeedMissing && kind <= StopKind::kContourWords;
}

}  // namespace owlint
