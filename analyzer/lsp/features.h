// What the server can do with documents, with one file for each feature. Each function takes a request's params and returns
// its result; wrong params throw Json's exceptions, and a refusal is a ResponseError.
#pragma once

#include "analyzer/lsp/workspace.h"

namespace owlint::lsp {

// diagnostics.cc
Json diagnostics_of(const Document& document, const std::vector<Finding>& findings);
Json document_diagnostic(Workspace& workspace, const Json& params);
Json workspace_diagnostic(Workspace& workspace, const Json& params);

// navigation.cc
Json definition(Workspace& workspace, const Json& params);
Json references(Workspace& workspace, const Json& params);
Json document_highlight(Workspace& workspace, const Json& params);

// rename.cc
Json prepare_rename(Workspace& workspace, const Json& params);
Json rename(Workspace& workspace, const Json& params);

// symbols.cc
Json document_symbol(Workspace& workspace, const Json& params);
Json workspace_symbol(Workspace& workspace, const Json& params);
Json document_link(Workspace& workspace, const Json& params);
Json code_lens(Workspace& workspace, const Json& params);

// folding.cc
Json folding_range(Workspace& workspace, const Json& params);
Json selection_range(Workspace& workspace, const Json& params);

// hierarchy.cc
Json prepare_call_hierarchy(Workspace& workspace, const Json& params);
Json incoming_calls(Workspace& workspace, const Json& params);
Json outgoing_calls(Workspace& workspace, const Json& params);

// completion.cc
Json completion(Workspace& workspace, const Json& params);

// hover.cc
Json hover(Workspace& workspace, const Json& params);

// ini_help.cc: the same for a machine's INI
Json ini_hover(Workspace& workspace, const Json& params);
Json ini_completion(Workspace& workspace, const Json& params);

// ini_navigation.cc
Json ini_definition(Workspace& workspace, const Json& params);
Json ini_references(Workspace& workspace, const Json& params);
Json ini_document_link(Workspace& workspace, const Json& params);
Json ini_document_symbol(Workspace& workspace, const Json& params);

// hints.cc
Json signature_help(Workspace& workspace, const Json& params);
Json inlay_hint(Workspace& workspace, const Json& params);

// tokens.cc
Json semantic_tokens_legend();
Json semantic_tokens_full(Workspace& workspace, const Json& params);
Json semantic_tokens_delta(Workspace& workspace, const Json& params);
Json semantic_tokens_range(Workspace& workspace, const Json& params);

// formatting.cc
Json formatting(Workspace& workspace, const Json& params);
Json range_formatting(Workspace& workspace, const Json& params);
Json on_type_formatting(Workspace& workspace, const Json& params);

// actions.cc
Json code_action(Workspace& workspace, const Json& params);
Json execute_command(Workspace& workspace, const Json& params);

}  // namespace owlint::lsp
