#!/usr/bin/env python3
"""Makes the wheel of the package tautline. The same files give the same bytes.

  make_wheel.py PACKAGE VERSION OUT    PACKAGE: the folder `tautline` with its libraries, from the build

Needs Python's own library alone, and `strip` if it is here. A library that needs a newer glibc than the tag promises
is refused.
"""
import base64
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import zipfile

GLIBC = (2, 34)
TAG = f"py3-none-manylinux_{GLIBC[0]}_{GLIBC[1]}_x86_64"
ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent


def metadata(version):
    return f"""Metadata-Version: 2.1
Name: tautline
Version: {version}
Summary: The exact motion of rigid bodies on slack cables
License: Apache-2.0
License-File: LICENSE
License-File: THIRD_PARTY.md
Requires-Python: >=3.11
Requires-Dist: numpy>=1.24
Classifier: License :: OSI Approved :: Apache Software License
Classifier: Operating System :: POSIX :: Linux
Classifier: Programming Language :: Python :: 3
Classifier: Topic :: Scientific/Engineering :: Physics
Classifier: Typing :: Typed
Description-Content-Type: text/markdown

{(HERE / "README.md").read_text(encoding="utf-8").split("<!-- for who builds it -->")[0].rstrip()}
"""


def newest_glibc(library):
    """The newest version of glibc that a library asks for."""
    table = subprocess.run(["objdump", "-T", library], check=True, capture_output=True, text=True).stdout
    return max(tuple(map(int, found.split("."))) for found in re.findall(r"\(GLIBC_([0-9.]+)\)", table))


def library_bytes(path):
    if newest_glibc(path) > GLIBC:
        raise SystemExit(f"make_wheel: {path} needs glibc {newest_glibc(path)}, the tag {TAG} promises {GLIBC}")
    with tempfile.TemporaryDirectory() as folder:
        copy = shutil.copy(path, folder)
        if shutil.which("strip"):
            subprocess.run(["strip", "--strip-unneeded", copy], check=True)
        return pathlib.Path(copy).read_bytes()


def contents(package, version):
    """Each file of the wheel but its record, by its path."""
    files = {}
    for path in sorted(package.iterdir()):
        if path.is_file():
            files[f"tautline/{path.name}"] = library_bytes(path) if ".so" in path.name else path.read_bytes()
    info = f"tautline-{version}.dist-info"
    files[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    files[f"{info}/THIRD_PARTY.md"] = (ROOT / "THIRD_PARTY.md").read_bytes()
    files[f"{info}/METADATA"] = metadata(version).encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: tautline\nRoot-Is-Purelib: false\nTag: {TAG}\n".encode()
    return info, files


def main(package, version, out):
    info, files = contents(pathlib.Path(package), version)
    record = ""
    for name, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(content)}\n"
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    date = time.gmtime(int(os.environ.get("SOURCE_DATE_EPOCH", "1704067200")))[:6]
    path = pathlib.Path(out) / f"tautline-{version}-{TAG}.whl"
    path.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(path, "w") as wheel:
        for name, content in files.items():
            entry = zipfile.ZipInfo(name, date)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o100755 if ".so" in name else 0o100644) << 16
            wheel.writestr(entry, content, compresslevel=9)
    print(path)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__.strip())
    main(*sys.argv[1:])
