"""recode_vti.py FROM TO: writes a .vti file with its appended raw data inline, in base64.

For one array, compressed, with 64-bit headers. ParaView 5.11 of Debian 12 cannot read raw data with
the libexpat of later updates (https://gitlab.kitware.com/vtk/vtk/-/issues/19258).
"""

import base64
import re
import struct
import sys


def recode(content):
    appended = content.index(b'<AppendedData encoding="raw">')
    begin = content.index(b"_", appended) + 1
    blocks = struct.unpack_from("<Q", content, begin)[0]
    sizes = struct.unpack_from("<%dQ" % blocks, content, begin + 24)
    middle = begin + 8 * (3 + blocks)
    parts = (content[begin:middle], content[middle : middle + sum(sizes)])
    data = b"".join(base64.b64encode(part) for part in parts)
    head = content[:appended].replace(b'format="appended"', b'format="binary"')
    head = re.sub(rb'\s+offset="0"\s*/?>(\s*</DataArray>)?', b">" + data + b"</DataArray>", head)
    return head + b"</VTKFile>\n"


if __name__ == "__main__":
    source, target = sys.argv[1:]
    with open(source, "rb") as file:
        recoded = recode(file.read())
    with open(target, "wb") as file:
        file.write(recoded)
