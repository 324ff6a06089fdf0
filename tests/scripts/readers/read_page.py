#!/usr/bin/env python3
"""Print the header of the payload in a page of drawing_viewer, as JSON (src/limn/viewer/payload.h)."""

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
print(json.dumps(json.loads(payload[4:4 + size])))
