"""Programs side by side: so many at a time, in their order, with all they say; an interrupt leaves none behind."""
import os
import sys
import time
import unittest

from support import InFolder

from report.child import INTERRUPTED
from report.side_by_side import cores_to_use, run_side_by_side


def program(text):
    return [sys.executable, "-S", "-c", text]


class SideBySide(InFolder):
    def test_so_many_at_a_time_in_their_order(self):
        begun, running, most = [], 0, 0

        def begin(name):
            nonlocal running, most
            begun.append(name)
            running += 1
            most = max(most, running)

        for _, done in run_side_by_side({name: program("pass") for name in "abcde"}, 2, begin):
            running -= 1
            self.assertEqual(done.returncode, 0)
        self.assertEqual((begun, most, running), (list("abcde"), 2, 0))

    def test_two_wait_for_one_another(self):
        """One after the other, the first would wait for ever."""
        waits = "import os, sys, time\nopen(sys.argv[1], 'w').close()\nwhile not os.path.exists(sys.argv[2]): time.sleep(0.01)"
        one, two = (os.path.join(self.folder, name) for name in ("one", "two"))
        ended = dict(run_side_by_side({"a": [*program(waits), one, two], "b": [*program(waits), two, one]}, 2, lambda _: None))
        self.assertEqual({name: done.returncode for name, done in ended.items()}, {"a": 0, "b": 0})

    def test_what_they_say_is_read_whole(self):
        n = 300000  # a pipe holds 65536
        (ended,) = run_side_by_side({"a": program(f"import sys; print('x' * {n}); print('why', file=sys.stderr); sys.exit(3)")}, 1, lambda _: None)
        self.assertEqual((ended[0], len(ended[1].stdout), ended[1].stderr, ended[1].returncode), ("a", n + 1, "why\n", 3))

    def test_an_interrupt_of_one_ends_all(self):
        note = os.path.join(self.folder, "heard")
        hears = f"import signal, sys, time\nsignal.signal(signal.SIGINT, lambda *_: (open({note!r}, 'w').close(), sys.exit(130)))\n" \
                f"open({note + '-ready'!r}, 'w').close()\ntime.sleep(60)"
        ends = f"import os, sys, time\nwhile not os.path.exists({note + '-ready'!r}): time.sleep(0.01)\nsys.exit({INTERRUPTED})"
        begin = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            list(run_side_by_side({"a": program(hears), "b": program(ends), "c": program("pass")}, 2, lambda _: None))
        self.assertTrue(os.path.exists(note))
        self.assertLess(time.monotonic() - begin, 30)

    def test_cores(self):
        self.assertGreaterEqual(cores_to_use(), 1)


if __name__ == "__main__":
    unittest.main()
