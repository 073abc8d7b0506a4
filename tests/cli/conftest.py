"""The command line, run in this process."""

import pytest

from pieper.cli import main


@pytest.fixture
def run(capsys):
    """Return a function that takes words and returns the status, and what was printed out and as an error."""

    def call(*words):
        with pytest.raises(SystemExit) as left:
            main([str(w) for w in words])
        out = capsys.readouterr()
        return int(left.value.code or 0), out.out, out.err

    return call
