// What an editor that can do everything in LSP 3.17 says of itself.

const dynamicRegistration = true;
const resolve = (...properties) => ({ properties });

export function fullCapabilities(encodings, pull) {
  return {
    general: {
      ...(encodings ? { positionEncodings: encodings } : {}),
      staleRequestSupport: { cancel: true, retryOnContentModified: [] },
      markdown: { parser: 'marked', version: '1.1.0' },
      regularExpressions: { engine: 'ECMAScript', version: 'ES2020' },
    },
    window: {
      workDoneProgress: true,
      showMessage: { messageActionItem: { additionalPropertiesSupport: true } },
      showDocument: { support: true },
    },
    workspace: {
      applyEdit: true,
      workspaceEdit: {
        documentChanges: true,
        resourceOperations: ['create', 'rename', 'delete'],
        failureHandling: 'textOnlyTransactional',
        normalizesLineEndings: true,
        changeAnnotationSupport: { groupsOnLabel: true },
      },
      didChangeConfiguration: { dynamicRegistration },
      didChangeWatchedFiles: { dynamicRegistration, relativePatternSupport: true },
      symbol: { dynamicRegistration, resolveSupport: resolve('location.range') },
      codeLens: { refreshSupport: true },
      executeCommand: { dynamicRegistration },
      workspaceFolders: true,
      semanticTokens: { refreshSupport: true },
      inlayHint: { refreshSupport: true },
      ...(pull ? { diagnostics: { refreshSupport: true } } : {}),
      fileOperations: { dynamicRegistration, didRename: true, willRename: true },
    },
    textDocument: {
      synchronization: { dynamicRegistration, didSave: true, willSave: false, willSaveWaitUntil: false },
      publishDiagnostics: {
        relatedInformation: true,
        versionSupport: true,
        tagSupport: { valueSet: [1, 2] },
        codeDescriptionSupport: true,
        dataSupport: true,
      },
      ...(pull ? { diagnostic: { dynamicRegistration, relatedDocumentSupport: true } } : {}),
      completion: {
        dynamicRegistration,
        contextSupport: true,
        completionItem: {
          snippetSupport: true,
          commitCharactersSupport: true,
          documentationFormat: ['markdown', 'plaintext'],
          deprecatedSupport: true,
          preselectSupport: true,
          insertReplaceSupport: true,
          labelDetailsSupport: true,
          resolveSupport: resolve('documentation', 'detail', 'additionalTextEdits'),
        },
        completionList: { itemDefaults: ['commitCharacters', 'editRange', 'insertTextFormat'] },
      },
      hover: { dynamicRegistration, contentFormat: ['markdown', 'plaintext'] },
      signatureHelp: {
        dynamicRegistration,
        contextSupport: true,
        signatureInformation: {
          documentationFormat: ['markdown', 'plaintext'],
          parameterInformation: { labelOffsetSupport: true },
          activeParameterSupport: true,
        },
      },
      definition: { dynamicRegistration, linkSupport: true },
      declaration: { dynamicRegistration, linkSupport: true },
      references: { dynamicRegistration },
      documentHighlight: { dynamicRegistration },
      documentSymbol: { dynamicRegistration, hierarchicalDocumentSymbolSupport: true },
      codeAction: {
        dynamicRegistration,
        isPreferredSupport: true,
        disabledSupport: true,
        dataSupport: true,
        resolveSupport: resolve('edit'),
        codeActionLiteralSupport: { codeActionKind: { valueSet: ['', 'quickfix', 'refactor', 'source', 'source.fixAll'] } },
      },
      codeLens: { dynamicRegistration },
      documentLink: { dynamicRegistration, tooltipSupport: true },
      formatting: { dynamicRegistration },
      rangeFormatting: { dynamicRegistration },
      onTypeFormatting: { dynamicRegistration },
      rename: { dynamicRegistration, prepareSupport: true, prepareSupportDefaultBehavior: 1 },
      foldingRange: { dynamicRegistration, foldingRange: { collapsedText: true } },
      selectionRange: { dynamicRegistration },
      callHierarchy: { dynamicRegistration },
      semanticTokens: {
        dynamicRegistration,
        requests: { range: true, full: { delta: true } },
        tokenTypes: ['keyword', 'comment', 'number', 'operator', 'function', 'parameter', 'variable', 'label', 'macro', 'string'],
        tokenModifiers: ['declaration', 'definition', 'readonly'],
        formats: ['relative'],
        overlappingTokenSupport: false,
        multilineTokenSupport: false,
      },
      inlayHint: { dynamicRegistration, resolveSupport: resolve('tooltip', 'label.tooltip') },
    },
  };
}
