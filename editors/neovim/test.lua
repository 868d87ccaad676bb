-- Run by `test` in this folder: findings, quick fix, rename and formatting, as owlint.lua brings them into a buffer.
local buffer = vim.api.nvim_get_current_buf()
local patience = 5000 -- milliseconds for each answer

local function expect(condition, message)
  if not condition then error(message, 0) end
end

local function wait_for(message, condition) expect(vim.wait(patience, condition, 20), 'waited in vain: ' .. message) end

local function lines() return vim.api.nvim_buf_get_lines(buffer, 0, -1, false) end

local function count(text)
  local _, found = table.concat(lines(), '\n'):gsub(vim.pesc(text), '')
  return found
end

local function findings(code)
  return vim.tbl_filter(function(finding) return finding.code == code end, vim.diagnostic.get(buffer))
end

-- The offered fixes of the lines' findings, and the client that offers them.
local function quick_fixes(first, last)
  local answers, problem = vim.lsp.buf_request_sync(buffer, 'textDocument/codeAction', {
    textDocument = vim.lsp.util.make_text_document_params(buffer),
    range = { start = { line = first, character = 0 }, ['end'] = { line = last, character = 0 } },
    context = { diagnostics = {}, only = { 'quickfix' } },
  }, patience)
  expect(answers, 'textDocument/codeAction: ' .. tostring(problem))
  local id, answer = next(answers)
  expect(answer and answer.result, 'textDocument/codeAction: ' .. vim.inspect(answer))
  return answer.result, vim.lsp.get_client_by_id(id)
end

local function test_finding()
  wait_for('OW104', function() return #findings('OW104') > 0 end)
  local found = findings('OW104')
  expect(#found == 1 and found[1].lnum == 32, 'OW104 belongs on line 33 alone: ' .. vim.inspect(found))
end

local function test_quick_fix()
  local actions, client = quick_fixes(32, 33)
  local fix = vim.tbl_filter(function(action) return action.isPreferred end, actions)[1]
  expect(fix, 'no preferred quick fix: ' .. vim.inspect(actions))
  vim.lsp.util.apply_workspace_edit(fix.edit, client.offset_encoding)
  expect(count('o130') == 3, 'the second block should have another label:\n' .. table.concat(lines(), '\n'))
  wait_for('OW104 to go', function() return #findings('OW104') == 0 end)
end

local function test_rename()
  local before = count('o200')
  vim.fn.search('o200 while')
  vim.lsp.buf.rename('o<slots>')
  wait_for('the rename', function() return count('o200') == 0 end)
  expect(before == 2 and count('o<slots>') == before, 'both lines of the loop should be renamed')
end

local function test_format()
  local indented = lines()
  vim.cmd('%left')
  local flat = lines()
  vim.bo[buffer].expandtab = true
  vim.bo[buffer].shiftwidth = 2
  if vim.lsp.buf.format then
    vim.lsp.buf.format({ timeout_ms = patience })
  else
    vim.lsp.buf.formatting_sync(nil, patience)
  end
  expect(vim.deep_equal(lines(), indented), 'the indentation should be back:\n' .. table.concat(lines(), '\n'))
  expect(vim.deep_equal(vim.tbl_map(vim.trim, indented), flat), 'only indentation should change')
end

for _, step in ipairs({ { 'finding', test_finding }, { 'quick fix', test_quick_fix }, { 'rename', test_rename }, { 'format', test_format } }) do
  local passed, problem = pcall(step[2])
  io.stdout:write((passed and 'passed: ' or 'failed: ') .. step[1] .. '\n')
  if not passed then
    io.stderr:write(tostring(problem) .. '\n')
    vim.cmd('cquit')
  end
end
vim.cmd('qall!')
