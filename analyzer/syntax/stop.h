// Why the interpreter stops at O-words: each reason is one error message of
// LinuxCNC, and belongs to one rule. The reader (this room) finds the first group, the flow room the second.
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
  kContourWords,       // the same of a contour, a spline or a thread
  kUserCodeMissing,    // `M110`: no file of that name, as far as is known
  kRemapWords,         // words that a remapped code passes to its sub
  kRemapTooDeep,       // remapped codes in the subs of remapped codes
  kM99Behind,          // the same of M99, in a sub
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
  kFileNameCase,    // the same, but a file has the name with capital letters
  kFileLacksSub,    // the same in the called file
  kFilePercent,     // the same at a `%` there
  kSubBeforeEntry,  // the same for a sub before the called one in its file
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

/// Whether a line stops with it while it is executed; the lines of a contour's sub are only read.
constexpr bool is_of_execution(StopKind kind) {
  return kind >= StopKind::kFeedMissing && kind <= StopKind::kContourWords;
}

}  // namespace owlint
