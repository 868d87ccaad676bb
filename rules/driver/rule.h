// What a rule is: its place in the catalogue, its page, its check. One rule, one file `owNNN_name.cc`; everything
// else about rules (`owlint rules`, `explain`, the JSON, the tests) is made from these objects.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "analyzer/findings/finding.h"
#include "analyzer/findings/suppression.h"
#include "analyzer/flow/flow.h"
#include "analyzer/machine/profile.h"
#include "analyzer/program/linker.h"
#include "analyzer/program/program.h"
#include "analyzer/syntax/nature.h"
#include "analyzer/text/paths.h"

namespace owlint {

class Reporter;
namespace flow {
class DataFlow;
}

/// The catalogue's groups, by the digit after `OW`.
enum class Group : uint8_t {
  kLinter,
  kAbortList,
  kBlocks,
  kLine,
  kFiles,
  kHazards,
  kDataFlow,
  kWords,
  kModes,
  kGeometry,
};
std::string_view group_title(Group group);

/// What rules look for in a file, collected in one pass over its lines: the flow's stops by rule and by statement, and the
/// few lines that each rule needs. A file may have millions of lines; no rule goes through all of them.
struct Index {
  /// `codes_known`: a code that the machine does not have is a mistake, even if its INI is not known; as further_faults().
  Index(const Program& program, const FlowResult& flow, const MachineWords& machine, bool codes_known);

  Nature nature;  ///< where it is no LinuxCNC program, that is the only finding
  std::unordered_map<std::string_view, std::vector<const FlowStop*>> by_code;
  std::unordered_map<std::string_view, std::vector<const Hazard*>> warned_by_code;
  std::unordered_set<uint64_t> unreadable;  ///< region << 32 | label: a line there has an unknown keyword
  std::unordered_map<NameId, StatementId>
      subs;  ///< by label: lines that LinuxCNC does not read as the `sub` they are meant to be
  std::map<std::pair<RegionId, NameId>, StatementId> openers;  ///< the same of blocks
  std::unordered_set<StatementId> spoken_for;  ///< lines whose mistake the finding about another line names
  std::vector<bool> at;                        ///< by statement: a stop, or a message under FEATURE 0x20, is there
  std::unordered_multimap<StatementId, const FlowStop*>
      consequences;  ///< by the statement of the mistake that causes them
  std::unordered_map<std::string_view, std::vector<StatementId>> unmet_by_code;  ///< reading errors that no run reaches
  std::vector<StatementId> sub_lines;                                            ///< `sub`, `endsub`, `return`
  std::vector<StatementId> ends;                                                 ///< M2, M30, M99, `%`
  std::vector<StatementId> program_numbers;                                      ///< O-words without a keyword
  std::vector<StatementId> stray_parts;  ///< parts and ends of blocks that belong to no block, or close one by mistake
  std::vector<StatementId> odd_lines;    ///< with an open name, a NUL, a carriage return inside, or a bad character
  std::vector<NameId> foreign_names;     ///< names with characters that are not ASCII
  std::vector<StatementId> several_items;  ///< lines that assign a parameter and do more
  std::vector<StatementId> tests;          ///< `if`, `elseif` and `while` with a condition
  std::vector<std::pair<StatementId, StatementId>>
      shared_labels;  ///< first lines of blocks in one region: the first with a label, and a later one

 private:
  void add_further(const Program& program, const FlowStop& stop, const MachineWords& machine, bool codes_known);
  void add_behind(const Program& program, const FlowResult& flow, bool codes_known);
  void add_line(const Program& program, StatementId id);
  void find_spoken_for(const Program& program, const FlowResult& flow, const std::vector<bool>& stopped);
  void find_shared_labels(const Program& program);

  std::deque<std::pair<LineError, FlowStop>> further_;  // what by_code refers to, beside the flow's stops
  std::deque<FlowStop> behind_;                         // and this
  std::vector<StatementId> machine_checks_;             // at which no run stops
};

/// Everything that a check may look at.
struct Input {
  const Program& program;
  const FlowResult& flow;
  const Profile& profile;
  const Linked& linked;  ///< the program with the files that it calls
  const std::vector<Suppression>& suppressions;
  const Index& index;
  const flow::DataFlow& data;
  std::unordered_set<long>& given_numbers;  ///< labels that fixes already take
  bool suppressions_applied = false;        ///< the second round, for rules about suppressions themselves
};

/// What a check of the machine's INI may look at.
struct SetupInput {
  const MachineSetup& setup;
  const Profile& profile;
  Library& library;
};

/// The rule's documentation: `owlint explain`, the pages under docs/. The tests check it: `bad` has the finding,
/// `good` has none, and the interpreter runs both.
struct Page {
  std::string_view what;             ///< what it finds, in a machinist's words
  std::string_view why;              ///< what LinuxCNC does, also under FEATURE 0x20
  std::string_view bad;              ///< a program
  std::string_view good;             ///< the same program fixed
  std::string_view fix;              ///< how to fix it, when to suppress it
  std::string_view level_reason;     ///< why its findings are errors, warnings or info
  std::string_view interpreter;      ///< the message LinuxCNC prints for `bad`; N stands for a line number
  std::string_view options;          ///< command line options that `bad` needs
  std::string_view moves = {};       ///< where the last rapid move of `bad` goes, as `X5`, if that shows the problem
  std::string_view moves_good = {};  ///< the same of `good`
};

struct Rule {
  std::string_view code;
  std::string_view name;
  std::string_view summary;
  Group group;
  Severity level;  ///< for a finding that some run reaches; info rules are off unless selected
  Page page;
  void (*check)(const Input&, Reporter&);
  void (*check_setup)(const SetupInput&,
                      Reporter&) = nullptr;  ///< for rules about the INI; their findings name its file
  bool of_programs = false;                  ///< true of programs only: not reported for files that others call
  bool of_callers = false;  ///< known from the calling program, if the run has it: not reported for the called file
  bool fades = false;       ///< its lines never run: editors show them faded
  bool any_file = false;    ///< counts as much in a file that is no program at all
  bool other_controller = false;  ///< says that a file is for another controller: the rest of the file is then a remark
  bool leaves_out = false;        ///< its lines never run: speaks for the mistakes in them
  bool label_reused = false;      ///< its stops are at a label that another block has
  bool label_shared = false;      ///< about a label that another block has, where no run stops
  bool inner_sub = false;         ///< about a sub, or its end, inside another one
  bool helper_clash = false;  ///< about a call that runs another file's sub: an inner sub of that label is the mistake
};

/// Collects a rule's findings. The rule sets position, words and what the interpreter does; code and severity come from the
/// rule.
class Reporter {
 public:
  Reporter(const Rule& rule, std::vector<Finding>& findings) : rule_(rule), findings_(findings) {}

  /// Adds a finding; the reference is valid until the next one is added.
  Finding& add(Span span, std::string message);
  /// The same in another file than the one that is checked.
  Finding& add(std::shared_ptr<const Source> source, Span span, std::string message);
  const Rule& rule() const { return rule_; }

 private:
  const Rule& rule_;
  std::vector<Finding>& findings_;
};

/// All rules, in the order of their codes.
const std::vector<const Rule*>& catalogue();
/// By code or name, in any case; null if there is none.
const Rule* find_rule(std::string_view code_or_name);
/// The rule that made a finding.
const Rule& rule_of(const Finding& finding);
/// Whether at least one code begins with `prefix`.
bool known_prefix(std::string_view prefix);
/// The code that a text means, wherever users write codes: `OW104` for `ow104` and `if-label-reused`, `OW1` for `ow1`; empty
/// if there is no such rule.
std::string code_meant(std::string_view text);
/// What is wrong with a text that means no code.
std::string unknown_rule(std::string_view text);
/// The same for words of a suppression; see CodeOf.
std::optional<std::string> suppressed_code(std::string_view word, bool first);
/// The code or rule name nearest to a misspelt one; empty when nothing is near.
std::string_view nearest_rule(std::string_view text);

}  // namespace owlint
