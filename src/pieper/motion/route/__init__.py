"""The best joint path along poses that leave something free, and the proof where there is none."""
