"""The best joint path along poses that leave something free, and what closes it where there is none."""
