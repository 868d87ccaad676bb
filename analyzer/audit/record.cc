#include "analyzer/audit/record.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "analyzer/audit/store.h"

namespace owlint::audit {
namespace {

/// Writes findings, and gathers the lines that they point at.
class Writer {
 public:
  nlohmann::json report(const FileReport& report) {
    nlohmann::json findings = nlohmann::json::array();
    for (const Finding& f : report.findings) findings.push_back(finding(*report.source, f));
    return {source(*report.source), std::move(findings)};
  }

  nlohmann::json list(const std::vector<FileReport>& reports) {
    nlohmann::json all = nlohmann::json::array();
    for (const FileReport& one : reports) all.push_back(report(one));
    return all;
  }

  nlohmann::json program(const ProgramReport& program) {
    return {{"own", report(program.own)},   {"called", list(program.called)},
            {"calls", program.calls},       {"python", program.python},
            {"sub_file", program.sub_file}, {"only_definitions", program.only_definitions}};
  }

  std::string finish(nlohmann::json json) {
    nlohmann::json sources = nlohmann::json::array();
    for (const auto& [source, lines] : sources_) {
      nlohmann::json kept = nlohmann::json::array();
      for (const uint32_t number : lines) {
        const Span line = source->line(number);
        kept.push_back({number, line.begin, std::string(source->slice(line))});
      }
      sources.push_back({source->path(), source->line_count(), std::move(kept)});
    }
    json["sources"] = std::move(sources);
    std::string bytes;
    nlohmann::json::to_msgpack(json, bytes);
    return bytes;
  }

 private:
  size_t source(const Source& source) {
    for (size_t i = 0; i < sources_.size(); ++i) {
      if (sources_[i].first == &source) return i;
    }
    sources_.emplace_back(&source, std::set<uint32_t>{});
    return sources_.size() - 1;
  }

  /// A place, and a promise that its lines are kept.
  nlohmann::json place(const Source& in, Span span) {
    std::set<uint32_t>& lines = sources_[source(in)].second;
    constexpr uint32_t kMost = 64;  // in between more than that nothing is shown
    const uint32_t first = in.position(span.begin).line;
    const uint32_t last = in.position(span.end).line;
    lines.insert(last);
    for (uint32_t line = first; line < last && line - first < kMost; ++line) lines.insert(line);
    return {span.begin, span.end};
  }

  nlohmann::json related(const Source& own, const std::vector<Related>& places) {
    nlohmann::json all = nlohmann::json::array();
    for (const Related& r : places) {
      const Source& in = r.source == nullptr ? own : *r.source;
      all.push_back(
          {place(in, r.span), r.message, r.source == nullptr ? nlohmann::json(nullptr) : nlohmann::json(source(in))});
    }
    return all;
  }

  static nlohmann::json point(const ArcSketch::Point& point) { return {point.right, point.up, point.words}; }

  static nlohmann::json sketch(const ArcSketch& arc) {
    nlohmann::json json{{"clockwise", arc.clockwise},
                        {"start", point(arc.start)},
                        {"end", point(arc.end)},
                        {"start_radius", {arc.start_radius, arc.start_radius_words}},
                        {"end_radius", {arc.end_radius, arc.end_radius_words}}};
    if (arc.center) json["center"] = point(*arc.center);
    if (arc.nearest) json["nearest"] = {point(arc.nearest->center), arc.nearest->radius, arc.nearest->words};
    return json;
  }

  nlohmann::json finding(const Source& own, const Finding& f) {
    const Source& in = f.source == nullptr ? own : *f.source;
    nlohmann::json fixes = nlohmann::json::array();
    for (const Fix& fix : f.fixes) {
      nlohmann::json edits = nlohmann::json::array();
      for (const Edit& edit : fix.edits) edits.push_back({place(in, edit.span), edit.text});
      fixes.push_back({fix.title, fix.safe, std::move(edits)});
    }
    nlohmann::json consequences = nlohmann::json::array();
    for (const Consequence& c : f.consequences) consequences.push_back({c.code, place(in, c.span), c.interpreter});
    nlohmann::json json{
        {"code", f.code},
        {"severity", static_cast<int>(f.severity)},
        {"span", place(in, f.span)},
        {"source", f.source == nullptr ? nlohmann::json(nullptr) : nlohmann::json(source(in))},
        {"scope", f.scope},
        {"message", f.message},
        {"help", f.help},
        {"interpreter", f.interpreter},
        {"reach", static_cast<int>(f.reach)},
        {"stops", f.stops},
        {"unproven", f.unproven},
        {"never_ends", f.never_ends},
        {"runs_other", f.runs_other},
        {"group", f.group},
        {"habit", f.habit_severity ? nlohmann::json(static_cast<int>(*f.habit_severity)) : nlohmann::json(nullptr)},
        {"related", related(in, f.related)},
        {"path", related(in, f.path)},
        {"fixes", std::move(fixes)},
        {"consequences", std::move(consequences)},
        {"block_delete", f.block_delete},
        {"versions", f.versions}};
    if (f.arc != nullptr) json["arc"] = sketch(*f.arc);
    return json;
  }

  std::vector<std::pair<const Source*, std::set<uint32_t>>> sources_;
};

using Sources = std::vector<std::shared_ptr<const Source>>;

/// What `work` returns, if the record that it reads is whole.
template <typename Work>
auto whole(const Work& work) {
  try {
    return work();
  } catch (const nlohmann::json::exception& problem) {
    throw StoreProblem(fmt::format("the store is damaged: {}", problem.what()));
  } catch (const std::out_of_range& problem) {
    throw StoreProblem(fmt::format("the store is damaged: {}", problem.what()));
  }
}

Span span_of(const nlohmann::json& json) { return {json.at(0).get<uint64_t>(), json.at(1).get<uint64_t>()}; }

std::shared_ptr<const Source> source_at(const nlohmann::json& json, const Sources& sources) {
  return json.is_null() ? nullptr : sources.at(json.get<size_t>());
}

std::vector<Related> related_of(const nlohmann::json& json, const Sources& sources) {
  std::vector<Related> all;
  for (const nlohmann::json& r : json)
    all.push_back({span_of(r.at(0)), r.at(1).get<std::string>(), source_at(r.at(2), sources)});
  return all;
}

ArcSketch::Point point_of(const nlohmann::json& json) { return {json.at(0), json.at(1), json.at(2)}; }

std::shared_ptr<const ArcSketch> sketch_of(const nlohmann::json& json) {
  ArcSketch arc;
  arc.clockwise = json.at("clockwise");
  arc.start = point_of(json.at("start"));
  arc.end = point_of(json.at("end"));
  arc.start_radius = json.at("start_radius").at(0);
  json.at("start_radius").at(1).get_to(arc.start_radius_words);
  arc.end_radius = json.at("end_radius").at(0);
  json.at("end_radius").at(1).get_to(arc.end_radius_words);
  if (json.contains("center")) arc.center = point_of(json.at("center"));
  if (json.contains("nearest")) {
    const nlohmann::json& nearest = json.at("nearest");
    arc.nearest = {point_of(nearest.at(0)), nearest.at(1), nearest.at(2)};
  }
  return std::make_shared<const ArcSketch>(std::move(arc));
}

Finding finding_of(const nlohmann::json& json, const Sources& sources) {
  Finding f;
  const Rule* rule = find_rule(json.at("code").get<std::string>());
  if (rule == nullptr) throw std::out_of_range("a rule that does not exist");
  f.code = rule->code;
  f.rule = rule->name;
  f.severity = static_cast<Severity>(std::clamp(json.at("severity").get<int>(), 1, 3));
  f.span = span_of(json.at("span"));
  f.source = source_at(json.at("source"), sources);
  json.at("scope").get_to(f.scope);
  json.at("message").get_to(f.message);
  json.at("help").get_to(f.help);
  json.at("interpreter").get_to(f.interpreter);
  f.reach = static_cast<Reach>(std::clamp(json.at("reach").get<int>(), 0, 2));
  f.stops = json.at("stops");
  f.unproven = json.at("unproven");
  f.never_ends = json.at("never_ends");
  f.runs_other = json.at("runs_other");
  json.at("group").get_to(f.group);
  if (!json.at("habit").is_null()) f.habit_severity = static_cast<Severity>(json.at("habit").get<int>());
  f.related = related_of(json.at("related"), sources);
  f.path = related_of(json.at("path"), sources);
  for (const nlohmann::json& fix : json.at("fixes")) {
    Fix& made = f.fixes.emplace_back();
    fix.at(0).get_to(made.title);
    made.safe = fix.at(1);
    for (const nlohmann::json& edit : fix.at(2))
      made.edits.push_back({span_of(edit.at(0)), edit.at(1).get<std::string>()});
  }
  for (const nlohmann::json& c : json.at("consequences")) {
    const Rule* other = find_rule(c.at(0).get<std::string>());
    if (other != nullptr) f.consequences.push_back({other->code, span_of(c.at(1)), c.at(2).get<std::string>()});
  }
  if (json.contains("arc")) f.arc = sketch_of(json.at("arc"));
  json.at("block_delete").get_to(f.block_delete);
  json.at("versions").get_to(f.versions);
  return f;
}

}  // namespace

std::string record_of(const checking::Checked& checked) {
  Writer writer;
  nlohmann::json json{{"report", writer.program(checked.report)}, {"among_subs", checked.among_subs}};
  if (checked.as_sub) json["as_sub"] = writer.program(*checked.as_sub);
  return writer.finish(std::move(json));
}

std::string record_of(const std::vector<FileReport>& reports) {
  Writer writer;
  nlohmann::json json{{"reports", writer.list(reports)}};
  return writer.finish(std::move(json));
}

size_t Records::add(const std::string& bytes) {
  return whole([&] { return take_in(bytes); });
}

size_t Records::take_in(const std::string& bytes) {
  nlohmann::json record = nlohmann::json::from_msgpack(bytes);
  for (const nlohmann::json& source : record.at("sources")) {
    Kept& kept = kept_[source.at(0).get<std::string>()];
    kept.line_count = source.at(1);
    for (const nlohmann::json& line : source.at(2)) {
      const uint32_t number = line.at(0);
      kept.lines.try_emplace(number, KeptLine{number, line.at(1), line.at(2)});
    }
  }
  records_.push_back(std::move(record));
  return records_.size() - 1;
}

std::vector<std::shared_ptr<const Source>> Records::sources_of(const nlohmann::json& record) {
  Sources sources;
  for (const nlohmann::json& json : record.at("sources")) {
    const auto at = kept_.find(json.at(0).get_ref<const std::string&>());
    if (at->second.source == nullptr) {
      std::vector<KeptLine> lines;
      for (auto& [number, line] : at->second.lines) lines.push_back(std::move(line));
      at->second.source = Source::excerpt(at->first, lines, at->second.line_count);
    }
    sources.push_back(at->second.source);
  }
  return sources;
}

FileReport Records::report(const nlohmann::json& json, const Sources& sources) const {
  FileReport report;
  report.source = sources.at(json.at(0).get<size_t>());
  for (const nlohmann::json& f : json.at(1)) report.findings.push_back(finding_of(f, sources));
  return report;
}

std::vector<FileReport> Records::list(const nlohmann::json& json, const Sources& sources) const {
  std::vector<FileReport> all;
  for (const nlohmann::json& one : json) all.push_back(report(one, sources));
  return all;
}

checking::Checked Records::checked(size_t number) {
  return whole([&] { return read_checked(records_[number]); });
}

checking::Checked Records::read_checked(const nlohmann::json& record) {
  const Sources sources = sources_of(record);
  const auto program = [&](const nlohmann::json& json) {
    ProgramReport out;
    out.own = report(json.at("own"), sources);
    out.called = list(json.at("called"), sources);
    json.at("calls").get_to(out.calls);
    json.at("python").get_to(out.python);
    out.sub_file = json.at("sub_file");
    out.only_definitions = json.at("only_definitions");
    return out;
  };
  checking::Checked checked;
  checked.report = program(record.at("report"));
  if (record.contains("as_sub")) checked.as_sub = program(record.at("as_sub"));
  checked.among_subs = record.at("among_subs");
  return checked;
}

std::vector<FileReport> Records::reports(size_t number) {
  return whole([&] { return list(records_[number].at("reports"), sources_of(records_[number])); });
}

}  // namespace owlint::audit
