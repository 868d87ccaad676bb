"""Entry module of the interpreter's Python plugin; the named parameters are wanted, and in a server the server."""
import os

import namedparams  # noqa: F401  (the interpreter finds it by this name)

if "SERVE" in os.environ:
    import server
    server.serve()
