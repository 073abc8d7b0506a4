"""URDF texts that the tests of robot files put together."""

from __future__ import annotations

import re

LIMITS = '<limit lower="-2" upper="2"/>'


def joint(name, parent, child, xyz="0 0 0", rpy="0 0 0", axis="0 0 1", kind="revolute", extra=LIMITS):
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="{axis}"/>{extra}</joint>'
    )


def robot(*joints):
    """Return the URDF of some joints, every link they name declared behind them."""
    named = re.findall(r'<(?:parent|child) link="([^"]*)"', "".join(joints))
    said = re.findall(r'<link name="([^"]*)"', "".join(joints))
    links = "".join(f'<link name="{link}"/>' for link in dict.fromkeys(named) if link and link not in said)
    return f'<?xml version="1.0"?><robot name="test">{"".join(joints)}{links}</robot>'


#: Three joints from "base" to "l3".
ARM = (
    joint("a", "base", "l1", "0 0 0.3"),
    joint("b", "l1", "l2", "0.3 0 0", axis="0 1 0"),
    joint("c", "l2", "l3", "0.25 0 0", axis="0 1 0"),
)


def fixed(name, parent, child, xyz="0 0 0", rpy="0 0 0", extra=""):
    return joint(name, parent, child, xyz, rpy, kind="fixed", extra=extra)


def slide(name, parent, child, lower=0.0, upper=0.04, axis="0 1 0", extra=""):
    limits = f'<limit lower="{lower}" upper="{upper}"/>{extra}'
    return joint(name, parent, child, "0 0 0.1", axis=axis, kind="prismatic", extra=limits)
