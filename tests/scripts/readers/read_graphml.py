# SPDX-License-Identifier: BSD-3-Clause
"""Prints the content of a GraphML file as JSON, read by Python's XML parser: read_graphml.py file"""

import json
import sys
import xml.etree.ElementTree as ElementTree

NAMESPACE = "{http://graphml.graphdrawing.org/xmlns}"
CONVERT = {"double": float, "int": int, "string": str, "boolean": {"true": True, "false": False}.__getitem__}


def attributes_of(element, keys):
    values = dict(element.attrib)
    for data in element.findall(NAMESPACE + "data"):
        domain, name, convert = keys[data.get("key")]
        assert element.tag == NAMESPACE + domain, (element.tag, name)
        values[name] = convert(data.text)
    return values


def main():
    root = ElementTree.parse(sys.argv[1]).getroot()
    assert root.tag == NAMESPACE + "graphml", root.tag
    keys = {key.get("id"): (key.get("for"), key.get("attr.name"), CONVERT[key.get("attr.type")])
            for key in root.findall(NAMESPACE + "key")}
    graphs = root.findall(NAMESPACE + "graph")
    assert len(graphs) == 1
    assert all(child.tag in (NAMESPACE + "node", NAMESPACE + "edge") for child in graphs[0])
    print(json.dumps({
        "edgedefault": graphs[0].get("edgedefault"),
        "nodes": [attributes_of(node, keys) for node in graphs[0].findall(NAMESPACE + "node")],
        "edges": [attributes_of(edge, keys) for edge in graphs[0].findall(NAMESPACE + "edge")],
    }))


main()
