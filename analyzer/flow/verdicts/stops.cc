#include "analyzer/flow/verdicts/stops.h"

#include <utility>

namespace owlint::flow {

std::string as_printed(std::string message) {
  constexpr size_t kLongest = 254;
  if (message.size() > kLongest) message.resize(kLongest);
  return message;
}

uint32_t Stops::add(RecordId record, FlowStop stop) {
  stop.interpreter = as_printed(std::move(stop.interpreter));
  // A stop without a line to blame is reported at the end of its file.
  const uint32_t file =
      stop.statement == kNoStatement && stop.end_of != kNoStatement ? linked_.file_of(stop.end_of) : 0;
  const Key key{stop.statement, stop.kind, stop.detail, file};
  const bool unproven = stop.unproven;
  const bool on_any_machine = !stop.on_new_machine;
  auto found = found_.find(key);
  if (found == found_.end()) {
    found = found_.emplace(key, Found{next_key_++, record, std::move(stop)}).first;
  } else if (found->second.stop.unproven && !unproven) {
    found->second.stop.unproven = false;
    found->second.record = record;
  }
  if (on_any_machine) found->second.stop.on_new_machine = false;
  trace_.terminate(record, found->second.key, unproven);
  return found->second.key;
}

}  // namespace owlint::flow
