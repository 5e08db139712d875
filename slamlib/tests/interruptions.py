"""Ctrl-C at a moment of the test's choice."""

import os
import signal


def interrupted_at(number):
    """In place of progress.progress: Ctrl-C is pressed while item `number` (from 0) is being worked on."""

    def interrupted(items, total, label):
        for i, item in enumerate(items):
            if i == number:
                os.kill(os.getpid(), signal.SIGINT)
            yield item

    return interrupted


def interrupted_after(write, number):
    """In place of a function that writes a file: Ctrl-C comes as soon as the folder has `number` files."""

    def interrupted(path, *content):
        write(path, *content)
        if len(list(path.parent.iterdir())) == number:
            raise KeyboardInterrupt

    return interrupted
