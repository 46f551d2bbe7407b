"""A second program for the profile `repaired`, written from its texts alone, and the levels it is compared on."""
