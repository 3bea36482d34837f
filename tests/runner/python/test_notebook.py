"""What a notebook shows of a clip, a motion and a report: their texts, and HTML that stands alone."""

from __future__ import annotations

from html.parser import HTMLParser

from dynsplines import Keyframe, build, inbetween


class _Tags(HTMLParser):
    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))


def test_a_motion_plays_in_a_notebook():
    clip = build("spinner", [Keyframe(0, others="rest"), Keyframe(1, others="previous")])
    motion = inbetween(clip)
    assert repr(clip).startswith("<Clip clip: 1.00 s, 2 keyframes")
    assert repr(motion).startswith("<Motion clip: 1.00 s, 2 keyframes")
    ((tag, attributes),) = _Tags(motion._repr_html_()).tags
    page = attributes["srcdoc"]
    assert tag == "iframe"
    assert page
    assert {"script", "title"} <= {name for name, _ in _Tags(page).tags}
    assert motion.report()._repr_html_().startswith("<pre>")
