"""Figures painted side by side are those painted one by one; one that cannot be painted is a problem, not an end."""
import os
import unittest
from typing import Any
from unittest import mock

from support import InFolder

from report import page
from report.blocks import Pictures, Section
from report.errors import IoError
from report.figure_processes import FigureProcesses
from report.style import figure, save


def curve(power: int, path: str) -> str:
    fig, axes = figure(1, 1, 2)
    axes[0, 0].plot([x**power for x in range(9)])
    return save(fig, path)


def unreadable_formula(path: str) -> str:
    fig, axes = figure(1, 1, 2)
    axes[0, 0].set_title(r"$\nosuchmacro$")  # found when it is painted
    return save(fig, path)


def drawn(folder: str, side_by_side: bool) -> tuple[list[dict[str, Any] | None], list[str]]:
    pictures = Pictures(folder, [])
    if side_by_side:
        pictures.begin()
    blocks = [pictures.figure(f"curve-{power}", "a curve", curve, power) for power in range(5)]
    blocks += [pictures.figure("bad", "none", unreadable_formula), pictures.figure("nothing", "", lambda path: None)]
    pictures.finish()
    return blocks, pictures.problems


class SideBySide(InFolder):
    def setUp(self) -> None:
        super().setUp()
        cores = mock.patch("report.blocks.cores_to_use", lambda: 2)
        cores.start()
        self.addCleanup(cores.stop)

    def test_the_same_blocks_and_problems(self) -> None:
        one_by_one, problems = drawn(os.path.join(self.folder, "a"), side_by_side=False)
        side_by_side, other = drawn(os.path.join(self.folder, "b"), side_by_side=True)
        self.assertEqual(problems, other)
        self.assertRegex(problems[0], "(?s)figure bad could not be drawn: .*nosuchmacro")
        self.assertEqual(side_by_side[:5], one_by_one[:5])
        self.assertTrue(one_by_one[0] and one_by_one[0]["source"].startswith("data:image/webp"))
        self.assertEqual((one_by_one[5], side_by_side[5], side_by_side[6]), (None, {}, None))

    def test_a_page_leaves_out_what_could_not_be_painted(self) -> None:
        blocks, problems = drawn(self.folder, side_by_side=True)
        section = Section("curves", "Curves", blocks=[block for block in blocks if block is not None])
        path = os.path.join(self.folder, "page.html")
        page.write(path, "page.html.j2", title="", subtitle="", sections=[section], problems=problems, footer="")
        self.assertEqual(len(section.blocks), 5)

    def test_a_file_that_cannot_be_written_ends_it(self) -> None:
        file = self.write("taken", "")
        pictures = Pictures(file, [])
        pictures.begin()
        self.assertTrue(pictures.figure("curve", "", curve, 1))
        with self.assertRaisesRegex(IoError, "taken"):
            pictures.finish()

    def test_a_process_that_dies_is_said(self) -> None:
        processes = FigureProcesses(1)
        for _ in range(3):  # more than fit side by side
            painting = processes.start(lambda: os._exit(9))
        with self.assertRaisesRegex(ValueError, "ended before it had painted"):
            processes.result(painting)


if __name__ == "__main__":
    unittest.main()
