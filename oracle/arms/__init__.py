"""The arms that tests and benchmarks ask: tables, random ones of every kind, chains, known ones without limits."""
