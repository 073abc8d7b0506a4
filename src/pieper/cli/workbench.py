"""`pieper workbench`: the arm live in the browser."""

from __future__ import annotations

import contextlib
import functools

import click

import pieper
from pieper.cli.options import takes_arm
from pieper.cli.status import DONE


@click.command("workbench", short_help="Open the workbench in the browser.")
@functools.partial(takes_arm, default="denso-vp6242")
@click.option("--host", default="127.0.0.1", show_default=True, help="Address to listen on.")
@click.option("--port", default=8123, show_default=True, help="Port to listen on; 0 for a free one.")
@click.option("--browser/--no-browser", default=True, help="Whether to open a browser.")
@click.option(
    "--open-to-network", is_flag=True, help="Allow an address that other machines reach; there is no password."
)
def command(arm: pieper.Arm, host: str, port: int, browser: bool, open_to_network: bool) -> int:
    """Open the workbench: the arm, its joints, poses and equations, live in the browser."""
    from pieper.workbench import serve

    # Ctrl-C, or whatever ends a service, is how one leaves it: nothing was interrupted
    with contextlib.suppress(KeyboardInterrupt):
        serve(host=host, port=port, arm=arm, open_to_network=open_to_network, open_browser=browser)
    return DONE
