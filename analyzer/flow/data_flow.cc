#include "analyzer/flow/data_flow.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <unordered_set>

namespace owlint::flow {
namespace {

ParameterId parameter_of(uint64_t key) {
  const auto plain = static_cast<uint32_t>(key);
  const uint32_t names = (key & LineAccess::kGlobal) != 0 ? kGlobalNames : kLocalNames;
  return plain >= names ? ParameterId{plain - names, true} : ParameterId{plain, false};
}

bool is_number(uint64_t key) { return key < kFirstGlobalNumber; }

/// Whether a comment prints the parameters in it: `(debug, …)`, `(print, …)`, `(log, …)`.
bool prints(std::string_view comment) {
  std::string word;
  for (size_t i = comment.find_first_not_of(" \t"); i < comment.size() && comment[i] != ',' && word.size() < 8; ++i) word += static_cast<char>(std::tolower(static_cast<unsigned char>(comment[i])));
  return word == "debug" || word == "print" || word == "log" || word == "abort";
}

/// Parameters that comments print.
std::vector<uint64_t> in_comments(const Program& program) {
  const std::string_view text = program.source->bytes();
  std::vector<uint64_t> keys;
  for (size_t at = text.find('#'); at != std::string_view::npos; at = text.find('#', at + 1)) {
    const size_t feed = text.rfind('\n', at);
    const std::string_view before = text.substr(feed + 1, at - feed - 1);  // a line at most; those that are read are short
    const size_t open = before.rfind('(');
    if (open == std::string_view::npos || before.find(')', open) != std::string_view::npos || !prints(before.substr(open + 1))) continue;
    std::string name;
    size_t end = at + 1;
    if (end < text.size() && text[end] == '<') {
      for (++end; end < text.size() && text[end] != '>' && text[end] != '\n'; ++end) {
        if (text[end] != ' ' && text[end] != '\t') name += static_cast<char>(std::tolower(static_cast<unsigned char>(text[end])));
      }
      const NameId id = program.syntax.names.find(name);
      if (id != kNoName) keys.push_back(is_global_name(name) ? (kGlobalNames + id) | LineAccess::kGlobal : kLocalNames + id);
    } else {
      for (; end < text.size() && name.size() < 3 && std::isdigit(static_cast<unsigned char>(text[end])) != 0; ++end) name += text[end];
      if (!name.empty()) keys.push_back(std::stoul(name));
    }
  }
  std::ranges::sort(keys);
  return keys;
}

}  // namespace

std::string parameter_text(const Program& program, ParameterId parameter) {
  return parameter.named ? "#<" + program.name(parameter.id) + ">" : "#" + std::to_string(parameter.id);
}

struct DataFlow::Sub {
  Sub(const Program& program, const Structure& structure, RegionId region, std::span<const uint32_t> statements)
      : flow(program, structure, region, statements), live(program, flow, region == kMainRegion) {}

  ControlFlow flow;
  Liveness live;
  Summary summary;
};

int Summary::last_argument() const { return arguments == 0 ? 0 : 31 - std::countl_zero(arguments); }

DataFlow::DataFlow(const Program& program) : program_(program), structure_(program), subs_(program.regions.size()) {
  statements_.assign(program.regions.size(), static_cast<uint32_t>(program.size()), [&](StatementId id) { return program.region_of[id]; });
}

DataFlow::~DataFlow() = default;

const DataFlow::Sub& DataFlow::look(RegionId region) const {
  std::unique_ptr<Sub>& sub = subs_[region];
  if (sub == nullptr) {
    sub = std::make_unique<Sub>(program_, structure_, region, statements_[region]);
    if (sub->live.known()) summarize(*sub);
  }
  return *sub;
}

const Summary& DataFlow::of(RegionId region) const { return look(region).summary; }

void DataFlow::summarize(Sub& sub) const {
  Summary& out = sub.summary;
  const auto& nodes = sub.flow.nodes();
  out.known = !nodes.empty();
  if (!out.known) return;
  std::unordered_set<uint64_t> read;
  std::unordered_set<uint64_t> written;
  const NameId count = program_.syntax.names.find("n_args");  // how many were passed, if the INI wants it
  LineAccess line;
  for (const auto& node : nodes) {
    line.look(program_, node.statement);
    out.any_number = out.any_number || line.reads_any || (count != kNoName && std::ranges::count(line.reads, kLocalNames + uint64_t{count}) > 0);
    for (const uint64_t key : line.reads) {
      if ((key & LineAccess::kGlobal) != 0 && read.insert(key).second) out.reads.push_back(parameter_of(key));
    }
    for (const auto& write : line.writes) {
      if (write.key != UINT64_MAX && (write.key & LineAccess::kGlobal) != 0 && written.insert(write.key).second) out.writes.push_back(parameter_of(write.key));
    }
  }
  for (uint32_t n = 1; n < kFirstGlobalNumber; ++n) {
    if (sub.live.before(0, n)) out.arguments |= 1U << n;
  }
  std::vector<bool> seen(nodes.size());
  std::vector<NodeId> todo{0};
  bool with = false;
  bool without = false;
  while (!todo.empty()) {
    const NodeId id = todo.back();
    todo.pop_back();
    if (seen[id]) continue;
    seen[id] = true;
    const Statement& s = program_.at(nodes[id].statement);
    const bool comes_back = s.is(Keyword::kReturn) || s.is(Keyword::kEndsub);
    if (comes_back) (s.value_count > 0 ? with : without) = true;
    for (const NodeId next : nodes[id].next) {
      if (next < nodes.size()) todo.push_back(next);
    }
  }
  out.returns = with ? (without ? Returns::kSometimes : Returns::kValue) : Returns::kNothing;
}

const std::vector<uint64_t>& DataFlow::printed() const {
  if (!printed_) printed_ = in_comments(program_);
  return *printed_;
}

bool DataFlow::printed(uint64_t key) const { return std::ranges::binary_search(printed(), key); }

int DataFlow::last_printed_argument() const {
  const auto end = std::ranges::lower_bound(printed(), static_cast<uint64_t>(kFirstGlobalNumber));
  return end == printed().begin() ? 0 : static_cast<int>(end[-1]);
}

void DataFlow::find_unused(RegionId region, std::vector<UnusedValue>& out) const {
  const Sub& sub = look(region);
  if (!sub.summary.known) return;
  const auto& nodes = sub.flow.nodes();
  LineAccess line;
  std::unordered_set<uint64_t> read;
  std::vector<uint32_t> ways_in(nodes.size() + 1);
  for (const auto& node : nodes) {
    line.look(program_, node.statement);
    read.insert(line.reads.begin(), line.reads.end());
    for (const NodeId next : node.next) {
      if (next < nodes.size()) ++ways_in[next];
    }
  }
  std::unordered_set<uint64_t> told;
  LineAccess next_line;
  for (NodeId id = 0; id < nodes.size(); ++id) {
    line.look(program_, nodes[id].statement);
    for (const auto& write : line.writes) {
      if ((write.key & LineAccess::kGlobal) != 0) continue;  // also the computed ones
      if (is_number(write.key) && sub.summary.any_number) continue;
      if (!read.contains(write.key)) {
        // Numbers are anybody's: what the sub leaves in them is lost, which is another rule's, or the operator's. A name
        // for something that has a number or a name already is a remark as well.
        const Operator value = program_.syntax.exprs[program_.syntax.items[program_.at(nodes[id].statement).first + write.item].value].op;
        if (is_number(write.key) || value == Operator::kParameter || value == Operator::kNamed || printed(write.key) || !told.insert(write.key).second) continue;
        out.push_back({nodes[id].statement, write.item, parameter_of(write.key), kNoStatement});
      } else if (!sub.live.after(id, write.key)) {
        const NodeId next = nodes[id].next[0];
        if (next >= nodes.size() || nodes[id].next[1] != kNowhere || ways_in[next] != 1 || program_.at(nodes[next].statement).kind != LineKind::kWords) continue;
        next_line.look(program_, nodes[next].statement);
        const bool again = std::ranges::any_of(next_line.writes, [&](const auto& other) { return other.key == write.key; });
        if (again && !printed(write.key)) out.push_back({nodes[id].statement, write.item, parameter_of(write.key), nodes[next].statement});
      }
    }
  }
}

const std::vector<UnusedValue>& DataFlow::unused() const {
  if (!unused_) {
    unused_.emplace();
    for (RegionId region = 0; region < program_.regions.size(); ++region) find_unused(region, *unused_);
    std::ranges::stable_sort(*unused_, {}, &UnusedValue::statement);
  }
  return *unused_;
}

const std::vector<FixedCondition>& DataFlow::fixed() const {
  if (!fixed_) {
    const Settings settings(program_);
    fixed_.emplace();
    for (RegionId region = 0; region < program_.regions.size(); ++region) {
      const ControlFlow& flow = look(region).flow;
      if (flow.known()) find_fixed_conditions(program_, flow, settings, *fixed_);
    }
    std::ranges::stable_sort(*fixed_, {}, &FixedCondition::statement);
  }
  return *fixed_;
}

StatementId DataFlow::left_behind(RegionId region, uint32_t number) const {
  const Sub& sub = look(region);
  if (!sub.summary.known || sub.summary.any_number || printed(number)) return kNoStatement;
  const auto& nodes = sub.flow.nodes();
  LineAccess line;
  for (NodeId id = static_cast<NodeId>(nodes.size()); id-- > 0;) {
    line.look(program_, nodes[id].statement);
    const bool assigns = std::ranges::any_of(line.writes, [&](const auto& write) { return write.key == number; });
    if (assigns) return sub.live.after(id, number) ? kNoStatement : nodes[id].statement;
  }
  return kNoStatement;
}

bool DataFlow::expects_from_call(StatementId call, uint32_t number) const {
  const Sub& sub = look(program_.region_of[call]);
  if (!sub.summary.known) return false;
  const auto& nodes = sub.flow.nodes();
  bool read_behind = false;
  LineAccess line;
  for (NodeId id = 0; id < nodes.size(); ++id) {
    line.look(program_, nodes[id].statement);
    if (std::ranges::any_of(line.writes, [&](const auto& write) { return write.key == number || write.key == UINT64_MAX; })) return false;
    // As nothing assigns it here, whatever reads it behind the call reads what the caller had.
    read_behind = read_behind || (nodes[id].statement > call && std::ranges::count(line.reads, number) > 0);
  }
  return read_behind;
}

}  // namespace owlint::flow
