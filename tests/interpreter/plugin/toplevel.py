"""Entry module of the interpreter's Python plugin; only the named parameters are wanted."""
import namedparams  # noqa: F401  (the interpreter finds it by this name)
