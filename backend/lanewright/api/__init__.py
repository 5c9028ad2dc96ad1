"""The web side: thin routes that parse, call a service and answer. One dependency commits (api.deps)."""
