// The program room: how the lines of a file belong together. Subs, blocks with their parts, calls. Built once from
// the syntax; the flow room and the rules read it.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analyzer/program/grouped.h"
#include "analyzer/syntax/statement.h"

namespace owlint {

using RegionId = uint32_t;
using BlockId = uint32_t;
inline constexpr RegionId kMainRegion = 0;
inline constexpr RegionId kNoRegion = UINT32_MAX;
inline constexpr BlockId kNoBlock = UINT32_MAX;

/// The main program, or the lines of one sub definition from its `sub` to its `endsub`. Labels of blocks are local
/// to a region.
struct Region {
  NameId name = kNoName;  ///< label of the sub; kNoName for the main program
  StatementId opener = kNoStatement;
  StatementId end = kNoStatement;  ///< the last `endsub` with the sub's label; none when it is missing
  StatementId early_end =
      kNoStatement;  ///< an `endsub` before that one: ends the definition when the interpreter skips it
  StatementId likely_end =
      kNoStatement;  ///< what was probably meant: an `endsub` with another label, or one that LinuxCNC does not read
  BlockId enclosing = kNoBlock;  ///< the block of the main program around the definition
  StatementId last = 0;          ///< one past the last statement that belongs to it
};

/// One `if`, `while`, `do` or `repeat` with everything that belongs to it.
struct Block {
  Keyword kind = Keyword::kIf;
  NameId label = kNoName;
  RegionId region = kMainRegion;
  StatementId opener = 0;
  StatementId end = kNoStatement;  ///< its end, or none
  BlockId parent = kNoBlock;
  BlockId crossed = kNoBlock;  ///< a block that ends between this one's opener and end without nesting in it
  StatementId mistaken_end = kNoStatement;  ///< a line that is probably meant to be the missing end, or not read as it
  uint32_t suggested_line = 0;              ///< the missing end probably belongs before this line; 0: no guess
};

/// One call: by an O-word, M98 or a contour, or by a remapped code.
struct Call {
  StatementId statement = 0;
  RegionId caller = kMainRegion;
  NameId callee = kNoName;      ///< kNoName: computed at run time
  RegionId target = kNoRegion;  ///< the region of the callee's first definition in this file
};

/// `o100` or `o<name>`, as a machinist would write the label.
std::string label_text(const std::string& name);

struct Program {
  std::shared_ptr<const Source> source;
  Syntax syntax;

  std::vector<Region> regions;      ///< [0] is the main program
  std::vector<RegionId> region_of;  ///< by statement
  std::vector<Block> blocks;        ///< region by region, in a region in the order of their openers
  Grouped parts;                    ///< by block: its `elseif` and `else`, in file order
  std::vector<BlockId> block_of;    ///< by statement: the block that it opens, divides, ends, breaks or continues
  std::vector<Call> calls;
  Grouped by_label;  ///< by NameId: the O-words with that label, in file order
  /// Of O-words that block delete leaves out, the number of the first line with each label and keyword.
  std::map<std::pair<NameId, Keyword>, uint32_t> left_out;

  /// The file is called from elsewhere: it defines the sub it is named after, and is no program itself.
  bool sub_file = false;
  NameId entry = kNoName;  ///< that sub

  const Statement& at(StatementId id) const { return syntax.statements[id]; }
  const std::string& name(NameId id) const { return syntax.names.text(id); }
  size_t size() const { return syntax.statements.size(); }
  std::string label_text(NameId id) const { return owlint::label_text(name(id)); }
  /// The label of a statement; a computed label as it is written.
  std::string label_at(StatementId id) const;
  /// `o100 if`: label and keyword of a statement.
  std::string head(StatementId id) const;
  /// The innermost block of a region that is open above a place: the lines before statement `place`.
  BlockId open_above(RegionId region, StatementId place) const;
  /// The first definition of a sub; kNoRegion if there is none.
  RegionId find_sub(std::string_view label) const;
  /// The block's keyword and label, `o100 if`.
  std::string head_of(const Block& block) const { return head(block.opener); }
};

/// From so many bytes on a file is read as usual programs are first (Expected). Only tests set it.
inline size_t large_program = 1 << 20;

/// Builds everything above from the bytes of one file.
std::unique_ptr<Program> build_program(std::shared_ptr<const Source> source, const MachineWords& machine = {});

/// The program as LinuxCNC runs it when block delete is on: without the lines that begin with `/`. Only errors of
/// comments and of a line's length are left of them (measured). The same program where there is no such line.
std::shared_ptr<const Program> without_deleted_lines(std::shared_ptr<const Program> program);

/// The names of the subs that one line of code outside any program calls.
std::vector<std::string> called_names(const std::string& code);

/// Whether a file defines the sub that a call of the file's name looks for.
bool defines_own_name(const Program& program);
/// Whether nothing is executed when the file is run as a program.
bool does_nothing(const Program& program);
/// Whether a file is a program, whatever its name: it lacks the sub of its own name, or what stands outside of subs calls
/// something or ends before that sub. Other code there is passed over when the file is called.
bool runs_by_itself(const Program& program);
/// Takes a file for one that others call, whatever else stands in it; it must define its own name.
void treat_as_sub_file(Program& program);

// Passes of build_program, each in its own file, and of joining programs (linker.h).
void find_regions(Program& program);
void match_blocks(Program& program);
void index_parts(Program& program);
void index_labels(Program& program);

}  // namespace owlint
