"""Folders of programs with names and contents that break reports which are put together carelessly."""
import os

# The folder that owlint runs in: its name is in SARIF's %SRCROOT% and in absolute paths.
ROOT = "own's \"root\" %41 ü&<b>#?".encode()

NAMES = [
    b"blanks in it.ngc",
    b" leading.ngc",
    b"-dash.ngc",
    b"quote'\"`.ngc",
    b"new\nline\rand\ttab.ngc",
    b"<script>alert(1)<\\script>.ngc",
    b"&amp;]]>--.ngc",
    b"::error::a%0A%25%3A,col=9.ngc",
    b"#hash?query=1;a+b.ngc",
    b"p:1:2: error: no [OW101].ngc",
    b"[link](1){0}{{}}.ngc",
    b"\x1b[31m\x01\x7f.ngc",
    b"latin-\xe4\xff.ngc",
    "umlaut-äöü€𝄞.ngc".encode(),
    "forbidden-in-xml-\ufffe\uffff.ngc".encode(),
    "separators-\u0085\u2028\u2029.ngc".encode(),
]

# A label that messages quote: escapes of every format, code points that XML forbids, bytes that are not UTF-8.
LABEL = b"o<a{0} [1](2) %0A::error::x,&'\"]]\xef\xbf\xbe\xef\xbf\xbf\xc3\xbc\xff\x1b[31m\x01\\>"

CONTENTS = [
    LABEL + b" if [1]\n",
    b"o100 if [#1 GT 2]\n (]]><!-- &lt; --><script>)\no100 endif\no100 while [#1 LT 0]\no100 endwhile\no7 return\nM2\n",
    "(äöü€𝄞) o1 if [1] ü\no1 endif ü\n".encode(),
    b"(\xe4\xf6) o<\xe4> if [1]\r\n(\xe4\xf6)o<\xe4\xfc> endif x\r\n",
    b"o110 while [#1 LT 2](3)\n#<b> = 2\no120 repeat [#<x]]> ]\no<b{1}> call\no101 foo[1](2) {0}\n",
    b"\xef\xbb\xbfo1 if [1] x\no<nix> return\n",
    b"%\no1 if [#1]\n  o2 if [#2]\n    o3 if [#3]\n      o4 retrun\n    o3 endif\n  o2 endif\no1 endif\no5 endsub\n%\n",
    b"o<unclosed if [1]\nG1 X1 o1 call",
    b"\0\0\x80\xfe o1 if\n" + b"x" * 300 + b" o2 if [1]\n",
]

# A program that is called, and what is wrong in it: the call is the other place.
CALLER = b"(<&>) G0 X1\n(\xc3\xbc)\no<helper> call [1] (\xc3\xbc)\no<helper> call [2]\nM2\n"
HELPER = b"o<helper> sub\n(\xc3\xbc) #1 = 2\no5 if [#1]\n  o5 while [1]\n  o5 endwhile\no5 endif\no<helper> endsub\n"

INI = ("[EMC]\nVERSION = 1.1\n[DISPLAY]\nPROGRAM_PREFIX = ../shop/calls\n[RS274NGC]\nFEATURES = 32\n"
       "SUBROUTINE_PATH = fehlt-ü&<b>%41:a b:'c'\n").encode()


def write(path, data):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "wb") as f:
        f.write(data)


def make(folder):
    """The hostile folder below `folder`: its root, in which there are `shop`, `clean`, `nothing` and an INI."""
    root = os.path.join(os.fsencode(folder), ROOT)
    for number, name in enumerate(NAMES):
        write(os.path.join(root, b"shop", name), CONTENTS[number % len(CONTENTS)])
    for number, content in enumerate(CONTENTS):
        write(os.path.join(root, b"shop", "unter ordner&".encode(), b"%d.ngc" % number), content)
    write(os.path.join(root, b"shop", b"calls", b"caller.ngc"), CALLER)
    write(os.path.join(root, b"shop", b"calls", b"helper.ngc"), HELPER)
    write(os.path.join(root, b"clean", "sauber ü.ngc".encode()), b"G0 X1\nM2\n")
    write(os.path.join(root, b"clean", b"second.ngc"), b"M2\n")
    os.makedirs(os.path.join(root, b"nothing"), exist_ok=True)
    write(os.path.join(root, b"maschine", "machine ü&.ini".encode()), INI)
    return root


# For the tests of the tests: one small program with all that a finding can have.
SAMPLE = (b"o100 if [#1 GT 2]\n  (x)\no100 endif\nG0 X1\no100 while [#1 LT 0]\no100 endwhile\n"
          b"(\xc3\xbc) o5 if [#2]\n  o7 return\no5 endif\nM2\n")
