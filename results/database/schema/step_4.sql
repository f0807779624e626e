-- From version 3 to 4.
ALTER TABLE withdrawals ADD COLUMN participant_hash TEXT;
