// The reasons for which the interpreter stops, as far as O-words are concerned: each is one error message of
// LinuxCNC, and belongs to one rule. The reader (this room) finds the first group, the flow room the second.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace owlint {

enum class StopKind : uint8_t {
  kNone,
  // Found while a line is read, wherever it stands (skipped lines too).
  kLineTooLong,
  kCommentNested,
  kCommentUnclosed,
  kLineNumber,       // N without digits
  kLabelMissing,     // `o` with no number
  kLabelWord,        // `o sub`: a word where the number should be
  kLabelNotInteger,  // `o1.5`
  kLabelExpression,  // malformed or failing `o[...]`
  kKeywordUnknown,   // not while a definition is passed over
  // Found while a line is read that is not skipped.
  kBracketMissing,
  kExpression,
  kTrailingText,
  kTooManyArguments,
  kWordBefore,
  kZeroForO,
  kLabelForgotten,  // `if [1]` without `o100`
  kBlockDelete,
  kBadCharacter,
  kM98NoTarget,
  kM98Number,
  // Found while a line is executed.
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
  kSubNotFound,     // end of file while a call seeks its sub
  kFileNameCase,    // the same, and a file has the name in other letters
  kFileLacksSub,    // the same in the called file
  kFilePercent,     // the same at a `%` there
  kSubBeforeEntry,  // the same for a sub that stands before the called one in its file
  kHelperRefused,   // LinuxCNC 2.10: a call of another sub in a called file
  kFileEnd,      // end of file with nothing sought, or while lines are skipped
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

}  // namespace owlint
