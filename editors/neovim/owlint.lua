-- owlint in Neovim 0.7 and later, with the built-in client. Copy this file into ~/.config/nvim/lua/ and write
-- `require('owlint')` into init.lua. If owlint is not in PATH, set `vim.g.owlint_path` before.
local group = vim.api.nvim_create_augroup('owlint', {})
local clients = {} -- the running server of each folder; only for Neovim before 0.8

-- The folder that a program belongs to: the nearest one with a configuration, else with a repository, else its own.
local function folder_of(file)
  local folder = vim.fn.fnamemodify(file, ':p:h')
  local above = vim.fn.fnameescape(folder) .. ';'
  for _, name in ipairs({ 'owlint.toml', '.owlint.toml' }) do
    local found = vim.fn.findfile(name, above)
    if found ~= '' then return vim.fn.fnamemodify(found, ':p:h') end
  end
  local repository = vim.fn.finddir('.git', above)
  return repository ~= '' and vim.fn.fnamemodify(repository, ':p:h:h') or folder
end

-- The keys that Neovim 0.11 and later have by default.
local function set_keys(_, buffer)
  local function key(keys, action) vim.keymap.set('n', keys, action, { buffer = buffer }) end
  key('gd', vim.lsp.buf.definition)
  key('K', vim.lsp.buf.hover)
  key('grn', vim.lsp.buf.rename)
  key('grr', vim.lsp.buf.references)
  key('gra', vim.lsp.buf.code_action)
  vim.bo[buffer].omnifunc = 'v:lua.vim.lsp.omnifunc'
end

local function start(buffer)
  local folder = folder_of(vim.api.nvim_buf_get_name(buffer))
  local program = vim.g.owlint_path or 'owlint'
  if vim.fn.executable(program) == 0 then
    vim.notify_once('owlint: the program `' .. program .. '` was not found; see vim.g.owlint_path', vim.log.levels.WARN)
    return
  end
  local config = { name = 'owlint', cmd = { program, 'lsp' }, root_dir = folder, on_attach = set_keys }
  if vim.lsp.start then
    vim.lsp.start(config, { bufnr = buffer })
    return
  end
  config.on_exit = function() clients[folder] = nil end
  clients[folder] = clients[folder] or vim.lsp.start_client(config)
  vim.lsp.buf_attach_client(buffer, clients[folder])
end

vim.api.nvim_create_autocmd({ 'BufRead', 'BufNewFile' }, {
  group = group,
  pattern = { '*.ngc', '*.nc', '*.tap', '*.cnc', '*.gcode' },
  callback = function() vim.bo.filetype = 'linuxcnc' end,
})

vim.api.nvim_create_autocmd('FileType', {
  group = group,
  pattern = 'linuxcnc',
  callback = function(event)
    vim.bo[event.buf].commentstring = '; %s'
    start(event.buf)
  end,
})

-- A machine's INI, and no other program's.
local function is_machine(buffer)
  for _, line in ipairs(vim.api.nvim_buf_get_lines(buffer, 0, -1, false)) do
    if line:match('^%s*%[EMC%]') or line:match('^%s*%[RS274NGC%]') then return true end
  end
  return false
end

vim.api.nvim_create_autocmd('BufRead', {
  group = group,
  pattern = '*.ini',
  callback = function(event)
    if is_machine(event.buf) then start(event.buf) end
  end,
})
