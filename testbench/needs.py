"""Tools that tests need beside the program. Without one a test skips and says so; scripts/test, which installs them all,
sets SAILMAP_TOOLS=required, and then the test fails instead: nothing passes there by not being run."""

import os
import unittest


def skip_without(found, what):
    """Decorator of a test or of a class of tests."""
    if not found and os.environ.get("SAILMAP_TOOLS") == "required":
        raise RuntimeError(f"no {what}, which scripts/setup should have installed")
    return unittest.skipUnless(found, f"no {what}")
