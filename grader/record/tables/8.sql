-- STAFF ONLY. Makes version 8 of 7. Records that began before extra credit had a share keep their totals.
ALTER TABLE class ADD COLUMN all_extra_credit INTEGER NOT NULL DEFAULT 0;  -- 1: it has no share
UPDATE class SET all_extra_credit = EXISTS (SELECT 1 FROM assignments WHERE made_by <> '' OR rules <> '')
  OR EXISTS (SELECT 1 FROM people);
