#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Print the header of the payload in a page of drawing_viewer, as JSON (src/limn/viewer/payload.h).

"nodes" is added: the positions of the nodes, relative to the center.
"""

import base64
import gzip
import json
import re
import struct
import sys
from pathlib import Path

# The payload is the longest run of base64 in the page.
packed = max(re.findall(r"[A-Za-z0-9+/=]{100,}", Path(sys.argv[1]).read_text()), key=len)
payload = gzip.decompress(base64.b64decode(packed))
size = struct.unpack_from("<I", payload)[0]
header = json.loads(payload[4:4 + size])
array = header["arrays"]["nodePositions"]
count = array["length"]
planes = payload[4 + size + array["offset"]:][:4 * count]
numbers = struct.unpack(f"<{count}f", bytes(planes[i + count * p] for i in range(count) for p in range(4)))
header["nodes"] = [numbers[i:i + 3] for i in range(0, count, 3)]
print(json.dumps(header))
