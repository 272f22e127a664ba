// Nothing: the precompiled headers of the tests belong to a target of their own.
