"""The registry under its former name, for the one module that still asks for it here."""

from slamlib.registry import Registry as Registry
