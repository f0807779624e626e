-- A database of version 5 as the sqlite3 shell dumps it: written by the program when that was the newest version
-- (deixis simulate, a small study; S003 withdrawn, S002 excluded), then rows added of what no simulated participant
-- leaves: tracked frames, a change of what is locked, an answer done again.
PRAGMA application_id=0x44584953;
PRAGMA user_version=5;
PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE study (
    id       INTEGER PRIMARY KEY CHECK (id = 1),
    name     TEXT NOT NULL,
    title    TEXT NOT NULL,
    hash     TEXT NOT NULL,
    source   TEXT,
    alpha    REAL NOT NULL,
    ball_diameter_m REAL,                -- NULL: brought over from an older version
    locked_hash TEXT,                    -- of all that a participant sees or that decides it; NULL: not locked
    analysis TEXT                        -- the other keys of [analysis], JSON; NULL: brought over from an older version
) STRICT;
INSERT INTO study VALUES(1,'kept','A study kept','7c0e9d4c41a9721a3df3bd8872e4a69c5858d3b12c75556be013d1e22208db82',replace('[study]\nname = "kept"\ntitle = "A study kept"\nseed = 5\n\n[targets]\ncount = 20\nheight_m = [0.5, 1.5]\narc_deg = [-60, 60]\nradius_m = [1.9, 2.2]\n\n[[distances]]\nname = "near"\ndistance_m = [0.2, 0.4]\ndistractors = 2\n\n[[layouts]]\nname = "across"\nviewer_m = [0, 3.4]\nheading_deg = 180\n\n[[systems]]\nname = "direct"\ngenerator = "direct"\n[[systems]]\nname = "stiff"\ngenerator = "stiff"\n\n[[between]]\nname = "light"\nlevels = ["dim", "bright"]\n\n[[stages]]\nname = "consent"\nkind = "consent"\ntext = "Do you take part?"\n\n[[stages]]\nname = "before"\nkind = "questionnaire"\nabout_participant = true\n[[stages.questions]]\nid = "age"\nkind = "number"\nlow = 18\nhigh = 99\ntext = "How old are you?"\n[[stages.questions]]\nid = "glasses"\nkind = "choice"\ntext = "Do you wear glasses?"\noptions = [{id = "yes", text = "Yes"}, {id = "no", text = "No"}]\n\n[[stages]]\nname = "rating-practice"\nkind = "practice"\nof = "rating"\nitems = 1\n\n[[stages]]\nname = "rating"\nkind = "rating"\nitems = 1\nlayouts = ["across"]\nquestion = "How natural?"\nscale = {low = 1, high = 5, labels = ["not", "very"]}\n[[stages.checks]]\nkind = "number"\ncount = 1\nrule = "warn"\n\n[[stages]]\nname = "game"\nkind = "referential-game"\nitems = 1\nlayouts = ["across"]\ndistances = ["near"]\nquestion = "Which ball?"\n[stages.confidence]\ntext = "How sure are you?"\nscale = {low = 1, high = 5}\n\n[[stages]]\nname = "load"\nkind = "questionnaire"\nfile = "load"\n','\n',char(10)),0.010000000000000000208,0.10000000000000000555,'c9566f091920fbb8485db7f10be7554fe3ccf2b12873d3bfbd92d21145fb9384','{"stations":"apart","unit":"participants","equivalence":{},"leave_out":{}}');
CREATE TABLE stages (
    position    INTEGER PRIMARY KEY,
    name        TEXT NOT NULL UNIQUE,
    kind        TEXT NOT NULL,           -- as in the study file
    sitting     INTEGER NOT NULL,        -- Stage::session
    practice_of TEXT,
    measure     TEXT,                    -- rating kinds
    scale_low   INTEGER,
    scale_high  INTEGER,
    question    TEXT
) STRICT;
INSERT INTO stages VALUES(0,'consent','consent',1,NULL,NULL,NULL,NULL,NULL);
INSERT INTO stages VALUES(1,'before','questionnaire',1,NULL,NULL,NULL,NULL,NULL);
INSERT INTO stages VALUES(2,'rating-practice','rating',1,'rating','rating',1,5,'How natural?');
INSERT INTO stages VALUES(3,'rating','rating',1,NULL,'rating',1,5,'How natural?');
INSERT INTO stages VALUES(4,'game','referential-game',1,NULL,NULL,NULL,NULL,'Which ball?');
INSERT INTO stages VALUES(5,'load','questionnaire',1,NULL,NULL,NULL,NULL,NULL);
CREATE TABLE systems (
    position  INTEGER PRIMARY KEY,
    name      TEXT NOT NULL UNIQUE,
    generator TEXT,
    manifest  TEXT,
    levels    TEXT NOT NULL DEFAULT '{}' -- JSON object, factor -> level
) STRICT;
INSERT INTO systems VALUES(0,'direct','direct',NULL,'{}');
INSERT INTO systems VALUES(1,'stiff','stiff',NULL,'{}');
CREATE TABLE layouts (
    position    INTEGER PRIMARY KEY,
    name        TEXT NOT NULL UNIQUE,
    viewer_x_m  REAL NOT NULL,
    viewer_z_m  REAL NOT NULL,
    heading_deg REAL NOT NULL
) STRICT;
INSERT INTO layouts VALUES(0,'across',0.0,3.3999999999999999111,180.0);
CREATE TABLE distances (
    position    INTEGER PRIMARY KEY,
    name        TEXT NOT NULL UNIQUE,
    low_m       REAL NOT NULL,
    high_m      REAL NOT NULL,
    distractors INTEGER NOT NULL
) STRICT;
INSERT INTO distances VALUES(0,'near',0.2000000000000000111,0.4000000000000000222,2);
CREATE TABLE questions (                 -- of questionnaires, rating, confidence, reasons
    stage    TEXT NOT NULL REFERENCES stages (name),
    question TEXT NOT NULL,
    position INTEGER NOT NULL,
    kind     TEXT NOT NULL,              -- scale, choice, choices, number, text
    text     TEXT NOT NULL,
    low      REAL,
    high     REAL,
    options  TEXT,                       -- JSON array of {id, text}
    labels   TEXT,                       -- of a scale's steps, or of its ends: JSON array; NULL: none
    PRIMARY KEY (stage, question)
) STRICT, WITHOUT ROWID;
INSERT INTO questions VALUES('before','age',0,'number','How old are you?',18.0,99.0,NULL,NULL);
INSERT INTO questions VALUES('before','glasses',1,'choice','Do you wear glasses?',NULL,NULL,'[{"id":"yes","text":"Yes"},{"id":"no","text":"No"}]',NULL);
INSERT INTO questions VALUES('game','confidence',0,'scale','How sure are you?',1.0,5.0,NULL,NULL);
INSERT INTO questions VALUES('load','effort',1,'scale','How much effort?',0.0,4.0,NULL,NULL);
INSERT INTO questions VALUES('load','mental',0,'scale','How hard?',0.0,4.0,NULL,NULL);
INSERT INTO questions VALUES('rating','rating',0,'scale','How natural?',1.0,5.0,NULL,'["not","very"]');
INSERT INTO questions VALUES('rating-practice','rating',0,'scale','How natural?',1.0,5.0,NULL,'["not","very"]');
CREATE TABLE scores (                    -- of questionnaires
    stage    TEXT NOT NULL REFERENCES stages (name),
    name     TEXT NOT NULL,
    position INTEGER NOT NULL,
    items    TEXT NOT NULL,              -- JSON array of question ids
    reversed TEXT NOT NULL,              -- JSON array
    mean     INTEGER NOT NULL CHECK (mean IN (0, 1)),
    factor   REAL NOT NULL,
    offset_  REAL NOT NULL,
    PRIMARY KEY (stage, name)
) STRICT, WITHOUT ROWID;
INSERT INTO scores VALUES('load','load',0,'["mental","effort"]','[]',0,1.0,0.0);
CREATE TABLE participants (
    id               TEXT PRIMARY KEY,
    number           INTEGER NOT NULL UNIQUE,
    language         TEXT NOT NULL,
    status           TEXT NOT NULL DEFAULT 'active' CHECK (status IN ('active', 'excluded', 'dropped')),
    reason           TEXT,               -- of exclusion or dropping out
    registered_utc_s REAL NOT NULL,
    token            TEXT,               -- drawn at random: stands for the person in withdrawals; NULL before the
                                         -- first session of who was registered before version 5
    CHECK ((status = 'active') = (reason IS NULL))
) STRICT, WITHOUT ROWID;
INSERT INTO participants VALUES('S001',1,'en','active',NULL,0.0,'2211a3bd7ec475169530ad39aedf0f50');
INSERT INTO participants VALUES('S002',2,'en','excluded','talked all the time',0.0,'6eb271fb3bb04aa1f4cc7eed840a5f0e');
CREATE TABLE participant_groups (
    participant TEXT NOT NULL REFERENCES participants (id),
    factor      TEXT NOT NULL,
    level       TEXT NOT NULL,
    PRIMARY KEY (participant, factor)
) STRICT, WITHOUT ROWID;
INSERT INTO participant_groups VALUES('S001','light','dim');
INSERT INTO participant_groups VALUES('S002','light','bright');
CREATE TABLE participant_fields (        -- age, gender, ...: the answers of stages about the participant
    participant TEXT NOT NULL REFERENCES participants (id),
    field       TEXT NOT NULL,
    value       REAL,
    text        TEXT,
    PRIMARY KEY (participant, field)
) STRICT, WITHOUT ROWID;
INSERT INTO participant_fields VALUES('S001','age',86.0,NULL);
INSERT INTO participant_fields VALUES('S001','glasses',1.0,'no');
INSERT INTO participant_fields VALUES('S002','age',72.0,NULL);
INSERT INTO participant_fields VALUES('S002','glasses',1.0,'no');
CREATE TABLE withdrawals (               -- nothing of the person is left but that there was one
    id    INTEGER PRIMARY KEY,
    utc_s REAL NOT NULL,
    token TEXT,                          -- the participant's: copies elsewhere are erased by it; NULL before version 5
    cleared INTEGER NOT NULL DEFAULT 1 CHECK (cleared IN (0, 1)) -- 0: free pages and log still hold traces
) STRICT;
INSERT INTO withdrawals VALUES(1,1795502370.4705338477,'a2cc614a349cbb5f90793b164cb86c4b',1);
CREATE TABLE plans (
    participant TEXT PRIMARY KEY REFERENCES participants (id),
    seed        TEXT NOT NULL,
    hash        TEXT NOT NULL,
    json        TEXT NOT NULL,
    locked_hash TEXT                     -- of the locked set that the plan was made from
) STRICT, WITHOUT ROWID;
INSERT INTO plans VALUES('S001','5','61a1e53ba270b5bf3fa026661fe34c937a56553254b773254c002e916e8313fe',replace('{\n  "participant": "S001",\n  "number": 1,\n  "number_in_cell": 1,\n  "study": "kept",\n  "study_hash": "7c0e9d4c41a9721a3df3bd8872e4a69c5858d3b12c75556be013d1e22208db82",\n  "seed": 5,\n  "groups": {"light":"dim"},\n  "stages": ["consent","before","rating-practice","rating","game","load"],\n  "trials": [\n    {"index":0,"stage":"consent","kind":"consent","practice":false,"attempt":0,"page":0,"stimuli":[],"layout":"across","distance":"","target":null,"distractors":[],"ball_order":[],"check":null},\n    {"index":1,"stage":"before","kind":"questionnaire","practice":false,"attempt":0,"page":0,"stimuli":[],"layout":"across","distance":"","target":null,"distractors":[],"ball_order":[],"check":null},\n    {"index":2,"stage":"rating-practice","kind":"rating","practice":true,"attempt":0,"page":0,"stimuli":[{"system":"direct","item":"T016"}],"layout":"across","distance":"","target":[1.1542,0.9093,1.7447],"distractors":[],"ball_order":[],"check":null},\n    {"index":3,"stage":"rating","kind":"rating","practice":false,"attempt":0,"page":0,"stimuli":[{"system":"stiff","item":"T009"}],"layout":"across","distance":"","target":[-0.697,0.6021,2.0277],"distractors":[],"ball_order":[],"check":{"kind":"number","stimulus":0,"expected":1.0,"of_trial":-1}},\n    {"index":4,"stage":"rating","kind":"rating","practice":false,"attempt":0,"page":0,"stimuli":[{"system":"direct","item":"T009"}],"layout":"across","distance":"","target":[-0.697,0.6021,2.0277],"distractors":[],"ball_order":[],"check":null},\n    {"index":5,"stage":"game","kind":"referential-game","practice":false,"attempt":0,"page":0,"stimuli":[{"system":"stiff","item":"T010"}],"layout":"across","distance":"near","target":[-0.9465,0.8091,1.9809],"distractors":[[-0.8399,1.0826,1.9737],[-1.2128,0.7507,1.6986]],"ball_order":[0,2,1],"check":null,"visibility":{"headset":{"at_rest":[1.0,1.0,1.0],"pointing":[1.0,1.0,1.0]},"desktop":{"at_rest":[1.0,1.0,1.0],"pointing":[1.0,1.0,1.0]}},"angles":{"avatar":[6.78,9.85],"headset":[7.9,3.37],"desktop":[7.9,3.37]}},\n    {"index":6,"stage":"game","kind":"referential-game","practice":false,"attempt":0,"page":0,"stimuli":[{"system":"direct","item":"T010"}],"layout":"across","distance":"near","target":[-0.9465,0.8091,1.9809],"distractors":[[-0.8399,1.0826,1.9737],[-1.2128,0.7507,1.6986]],"ball_order":[0,2,1],"check":null,"visibility":{"headset":{"at_rest":[1.0,1.0,1.0],"pointing":[1.0,1.0,1.0]},"desktop":{"at_rest":[1.0,1.0,1.0],"pointing":[1.0,1.0,1.0]}},"angles":{"avatar":[6.78,9.85],"headset":[7.9,3.37],"desktop":[7.9,3.37]}},\n    {"index":7,"stage":"load","kind":"questionnaire","practice":false,"attempt":0,"page":0,"stimuli":[],"layout":"across","distance":"","target":null,"distractors":[],"ball_order":[],"check":null}\n  ]\n}\n','\n',char(10)),'c9566f091920fbb8485db7f10be7554fe3ccf2b12873d3bfbd92d21145fb9384');
INSERT INTO plans VALUES('S002','5','1fd1c9f6fe1c7f9f0c854dc3cc6bca41d903ab10e02a8f7bba740be982e17560',replace('{\n  "participant": "S002",\n  "number": 2,\n  "number_in_cell": 1,\n  "study": "kept",\n  "study_hash": "7c0e9d4c41a9721a3df3bd8872e4a69c5858d3b12c75556be013d1e22208db82",\n  "seed": 5,\n  "groups": {"light":"bright"},\n  "stages": ["consent","before","rating-practice","rating","game","load"],\n  "trials": [\n    {"index":0,"stage":"consent","kind":"consent","practice":false,"attempt":0,"page":0,"stimuli":[],"layout":"across","distance":"","target":null,"distractors":[],"ball_order":[],"check":null},\n    {"index":1,"stage":"before","kind":"questionnaire","practice":false,"attempt":0,"page":0,"stimuli":[],"layout":"across","distance":"","target":null,"distractors":[],"ball_order":[],"check":null},\n    {"index":2,"stage":"rating-practice","kind":"rating","practice":true,"attempt":0,"page":0,"stimuli":[{"system":"direct","item":"T013"}],"layout":"across","distance":"","target":[0.0054,1.4424,1.9474],"distractors":[],"ball_order":[],"check":null},\n    {"index":3,"stage":"rating","kind":"rating","practice":false,"attempt":0,"page":0,"stimuli":[{"system":"stiff","item":"T015"}],"layout":"across","distance":"","target":[-0.697,1.0662,1.8053],"distractors":[],"ball_order":[],"check":{"kind":"number","stimulus":0,"expected":2.0,"of_trial":-1}},\n    {"index":4,"stage":"rating","kind":"rating","practice":false,"attempt":0,"page":0,"stimuli":[{"system":"direct","item":"T015"}],"layout":"across","distance":"","target":[-0.697,1.0662,1.8053],"distractors":[],"ball_order":[],"check":null},\n    {"index":5,"stage":"game","kind":"referential-game","practice":false,"attempt":0,"page":0,"stimuli":[{"system":"stiff","item":"T002"}],"layout":"across","distance":"near","target":[-0.3447,0.9625,1.9594],"distractors":[[-0.0621,0.7324,1.9813],[-0.0251,1.0629,2.1047]],"ball_order":[2,0,1],"check":null,"visibility":{"headset":{"at_rest":[1.0,1.0,1.0],"pointing":[1.0,1.0,1.0]},"desktop":{"at_rest":[1.0,1.0,1.0],"pointing":[1.0,1.0,1.0]}},"angles":{"avatar":[9.88,9.87],"headset":[12.46,11.23],"desktop":[12.46,11.23]}},\n    {"index":6,"stage":"game","kind":"referential-game","practice":false,"attempt":0,"page":0,"stimuli":[{"system":"direct","item":"T002"}],"layout":"across","distance":"near","target":[-0.3447,0.9625,1.9594],"distractors":[[-0.0621,0.7324,1.9813],[-0.0251,1.0629,2.1047]],"ball_order":[1,2,0],"check":null,"visibility":{"headset":{"at_rest":[1.0,1.0,1.0],"pointing":[1.0,1.0,1.0]},"desktop":{"at_rest":[1.0,1.0,1.0],"pointing":[1.0,1.0,1.0]}},"angles":{"avatar":[9.88,9.87],"headset":[12.46,11.23],"desktop":[12.46,11.23]}},\n    {"index":7,"stage":"load","kind":"questionnaire","practice":false,"attempt":0,"page":0,"stimuli":[],"layout":"across","distance":"","target":null,"distractors":[],"ball_order":[],"check":null}\n  ]\n}\n','\n',char(10)),'c9566f091920fbb8485db7f10be7554fe3ccf2b12873d3bfbd92d21145fb9384');
CREATE TABLE trials (
    participant    TEXT NOT NULL REFERENCES plans (participant),
    trial_index    INTEGER NOT NULL,
    stage          TEXT NOT NULL REFERENCES stages (name),
    kind           TEXT NOT NULL,
    practice       INTEGER NOT NULL CHECK (practice IN (0, 1)),
    attempt        INTEGER NOT NULL,
    page           INTEGER NOT NULL,
    layout         TEXT REFERENCES layouts (name),
    distance       TEXT REFERENCES distances (name),
    target_id      TEXT,                 -- the item; NULL on pages
    target_x_m     REAL,
    target_y_m     REAL,
    target_z_m     REAL,
    distractors    TEXT,                 -- game: JSON [[x,y,z],...]
    balls          TEXT,                 -- game: likewise, in the order shown
    target_place   INTEGER,              -- game: which of balls
    check_kind     TEXT CHECK (check_kind IN ('number', 'catch', 'repeat')),
    check_stimulus INTEGER,
    check_expected REAL,
    check_of_trial INTEGER,
    visibility     TEXT,                 -- JSON: what is seen of each ball
    angles         TEXT,                 -- JSON: how far the distractors look from the target
    PRIMARY KEY (participant, trial_index),
    CHECK ((balls IS NOT NULL) = (kind = 'referential-game')),
    CHECK ((balls IS NULL) = (target_place IS NULL))
) STRICT, WITHOUT ROWID;
INSERT INTO trials VALUES('S001',0,'consent','consent',0,0,0,'across',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO trials VALUES('S001',1,'before','questionnaire',0,0,0,'across',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO trials VALUES('S001',2,'rating-practice','rating',1,0,0,'across',NULL,'T016',1.1541999999999998927,0.90929999999999999715,1.7446999999999999175,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO trials VALUES('S001',3,'rating','rating',0,0,0,'across',NULL,'T009',-0.69699999999999995292,0.60209999999999996855,2.0276999999999998358,NULL,NULL,NULL,'number',0,1.0,NULL,NULL,NULL);
INSERT INTO trials VALUES('S001',4,'rating','rating',0,0,0,'across',NULL,'T009',-0.69699999999999995292,0.60209999999999996855,2.0276999999999998358,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO trials VALUES('S001',5,'game','referential-game',0,0,0,'across','near','T010',-0.94650000000000000799,0.80910000000000004138,1.9809000000000001051,'[[-0.8399,1.0826,1.9737],[-1.2128,0.7507,1.6986]]','[[-0.9465,0.8091,1.9809],[-1.2128,0.7507,1.6986],[-0.8399,1.0826,1.9737]]',0,NULL,NULL,NULL,NULL,'{"headset":{"at_rest":[1.0,1.0,1.0],"pointing":[1.0,1.0,1.0]},"desktop":{"at_rest":[1.0,1.0,1.0],"pointing":[1.0,1.0,1.0]}}','{"avatar":[6.78,9.85],"headset":[7.9,3.37],"desktop":[7.9,3.37]}');
INSERT INTO trials VALUES('S001',6,'game','referential-game',0,0,0,'across','near','T010',-0.94650000000000000799,0.80910000000000004138,1.9809000000000001051,'[[-0.8399,1.0826,1.9737],[-1.2128,0.7507,1.6986]]','[[-0.9465,0.8091,1.9809],[-1.2128,0.7507,1.6986],[-0.8399,1.0826,1.9737]]',0,NULL,NULL,NULL,NULL,'{"headset":{"at_rest":[1.0,1.0,1.0],"pointing":[1.0,1.0,1.0]},"desktop":{"at_rest":[1.0,1.0,1.0],"pointing":[1.0,1.0,1.0]}}','{"avatar":[6.78,9.85],"headset":[7.9,3.37],"desktop":[7.9,3.37]}');
INSERT INTO trials VALUES('S001',7,'load','questionnaire',0,0,0,'across',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO trials VALUES('S002',0,'consent','consent',0,0,0,'across',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO trials VALUES('S002',1,'before','questionnaire',0,0,0,'across',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO trials VALUES('S002',2,'rating-practice','rating',1,0,0,'across',NULL,'T013',0.0054000000000000002858,1.4423999999999999044,1.9474000000000000198,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO trials VALUES('S002',3,'rating','rating',0,0,0,'across',NULL,'T015',-0.69699999999999995292,1.0662000000000000365,1.8052999999999999047,NULL,NULL,NULL,'number',0,2.0,NULL,NULL,NULL);
INSERT INTO trials VALUES('S002',4,'rating','rating',0,0,0,'across',NULL,'T015',-0.69699999999999995292,1.0662000000000000365,1.8052999999999999047,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO trials VALUES('S002',5,'game','referential-game',0,0,0,'across','near','T002',-0.34470000000000000639,0.9625000000000000222,1.9594000000000000305,'[[-0.0621,0.7324,1.9813],[-0.0251,1.0629,2.1047]]','[[-0.0251,1.0629,2.1047],[-0.3447,0.9625,1.9594],[-0.0621,0.7324,1.9813]]',1,NULL,NULL,NULL,NULL,'{"headset":{"at_rest":[1.0,1.0,1.0],"pointing":[1.0,1.0,1.0]},"desktop":{"at_rest":[1.0,1.0,1.0],"pointing":[1.0,1.0,1.0]}}','{"avatar":[9.88,9.87],"headset":[12.46,11.23],"desktop":[12.46,11.23]}');
INSERT INTO trials VALUES('S002',6,'game','referential-game',0,0,0,'across','near','T002',-0.34470000000000000639,0.9625000000000000222,1.9594000000000000305,'[[-0.0621,0.7324,1.9813],[-0.0251,1.0629,2.1047]]','[[-0.0621,0.7324,1.9813],[-0.0251,1.0629,2.1047],[-0.3447,0.9625,1.9594]]',2,NULL,NULL,NULL,NULL,'{"headset":{"at_rest":[1.0,1.0,1.0],"pointing":[1.0,1.0,1.0]},"desktop":{"at_rest":[1.0,1.0,1.0],"pointing":[1.0,1.0,1.0]}}','{"avatar":[9.88,9.87],"headset":[12.46,11.23],"desktop":[12.46,11.23]}');
INSERT INTO trials VALUES('S002',7,'load','questionnaire',0,0,0,'across',NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
CREATE TABLE trial_stimuli (
    participant TEXT NOT NULL,
    trial_index INTEGER NOT NULL,
    position    INTEGER NOT NULL,        -- as shown, from 0; pairwise: 0 left, 1 right
    system      TEXT NOT NULL REFERENCES systems (name),
    item        TEXT NOT NULL,
    scored      INTEGER NOT NULL CHECK (scored IN (0, 1)),
    clip        INTEGER NOT NULL DEFAULT 0, -- which of the system's clips for the item, from 0
    PRIMARY KEY (participant, trial_index, position),
    FOREIGN KEY (participant, trial_index) REFERENCES trials (participant, trial_index)
) STRICT, WITHOUT ROWID;
INSERT INTO trial_stimuli VALUES('S001',2,0,'direct','T016',0,0);
INSERT INTO trial_stimuli VALUES('S001',3,0,'stiff','T009',0,0);
INSERT INTO trial_stimuli VALUES('S001',4,0,'direct','T009',1,0);
INSERT INTO trial_stimuli VALUES('S001',5,0,'stiff','T010',1,0);
INSERT INTO trial_stimuli VALUES('S001',6,0,'direct','T010',1,0);
INSERT INTO trial_stimuli VALUES('S002',2,0,'direct','T013',0,0);
INSERT INTO trial_stimuli VALUES('S002',3,0,'stiff','T015',0,0);
INSERT INTO trial_stimuli VALUES('S002',4,0,'direct','T015',1,0);
INSERT INTO trial_stimuli VALUES('S002',5,0,'stiff','T002',1,0);
INSERT INTO trial_stimuli VALUES('S002',6,0,'direct','T002',1,0);
CREATE TABLE sessions (
    id              INTEGER PRIMARY KEY,
    participant     TEXT NOT NULL REFERENCES plans (participant),
    station         TEXT NOT NULL,
    station_details TEXT NOT NULL,
    synthetic       INTEGER NOT NULL CHECK (synthetic IN (0, 1)),
    program_version TEXT NOT NULL,
    avatar_hash     TEXT NOT NULL,
    started_utc_s   REAL NOT NULL,
    ended_utc_s     REAL,
    outcome         TEXT CHECK (outcome IN ('finished', 'quit', 'aborted', 'declined', 'excluded')),
    UNIQUE (id, participant),
    CHECK ((ended_utc_s IS NULL) = (outcome IS NULL))
) STRICT;
INSERT INTO sessions VALUES(1,'S001','simulated','virtual time, nothing drawn; reads two-cue, noise 3 degrees, lapses 0.02',1,'deixis 0.1.0 (commit 78226e89e162)','2ab41a1835afaec852d559a901a72562bcc63361d2725d13cdd4b7db56326de6',0.0,35.13333333333333286,'finished');
INSERT INTO sessions VALUES(2,'S002','simulated','virtual time, nothing drawn; reads two-cue, noise 3 degrees, lapses 0.02',1,'deixis 0.1.0 (commit 78226e89e162)','2ab41a1835afaec852d559a901a72562bcc63361d2725d13cdd4b7db56326de6',0.0,35.3333333333333357,'finished');
CREATE TABLE locked_changes (            -- what was changed in a study under way
    id      INTEGER PRIMARY KEY,
    utc_s   REAL NOT NULL,
    what    TEXT NOT NULL,               -- JSON
    reason  TEXT
) STRICT;
INSERT INTO locked_changes VALUES(1,1760000000.5,'{"texts": ["game"]}','a word');
CREATE TABLE consents (
    participant TEXT NOT NULL REFERENCES participants (id),
    stage       TEXT NOT NULL REFERENCES stages (name),
    session     INTEGER NOT NULL REFERENCES sessions (id),
    agreed      INTEGER NOT NULL CHECK (agreed IN (0, 1)),
    utc_s       REAL NOT NULL,
    language    TEXT NOT NULL,
    text        TEXT NOT NULL,           -- what was agreed to
    PRIMARY KEY (participant, stage, session)
) STRICT, WITHOUT ROWID;
INSERT INTO consents VALUES('S001','consent',1,1,1.0333333333333334369,'en','Do you take part?');
INSERT INTO consents VALUES('S002','consent',2,1,0.86666666666666669627,'en','Do you take part?');
CREATE TABLE session_properties (
    session INTEGER NOT NULL REFERENCES sessions (id),
    name    TEXT NOT NULL,
    value   TEXT NOT NULL,
    PRIMARY KEY (session, name)
) STRICT, WITHOUT ROWID;
INSERT INTO session_properties VALUES(1,'operating_system','Debian GNU/Linux 12 (bookworm), Linux 6.18.44-fc-v445 x86_64');
INSERT INTO session_properties VALUES(1,'program_build_type','relwithdebinfo');
INSERT INTO session_properties VALUES(1,'program_built_on','Debian GNU/Linux 12 (bookworm) x86_64');
INSERT INTO session_properties VALUES(1,'program_commit','78226e89e162f2241b1e9293f31e9a04af1f3c07');
INSERT INTO session_properties VALUES(1,'program_compiler','Clang 14.0.6');
INSERT INTO session_properties VALUES(1,'program_libraries','SQLite 3.40.1, libpq 15.18, OpenSSL 3.0.19, zlib 1.2.13, GLM 0.9.9, glibc 2.36');
INSERT INTO session_properties VALUES(1,'program_uncommitted_changes','no');
INSERT INTO session_properties VALUES(2,'operating_system','Debian GNU/Linux 12 (bookworm), Linux 6.18.44-fc-v445 x86_64');
INSERT INTO session_properties VALUES(2,'program_build_type','relwithdebinfo');
INSERT INTO session_properties VALUES(2,'program_built_on','Debian GNU/Linux 12 (bookworm) x86_64');
INSERT INTO session_properties VALUES(2,'program_commit','78226e89e162f2241b1e9293f31e9a04af1f3c07');
INSERT INTO session_properties VALUES(2,'program_compiler','Clang 14.0.6');
INSERT INTO session_properties VALUES(2,'program_libraries','SQLite 3.40.1, libpq 15.18, OpenSSL 3.0.19, zlib 1.2.13, GLM 0.9.9, glibc 2.36');
INSERT INTO session_properties VALUES(2,'program_uncommitted_changes','no');
CREATE TABLE responses (
    id               INTEGER PRIMARY KEY,
    participant      TEXT NOT NULL,
    trial_index      INTEGER NOT NULL,
    session          INTEGER NOT NULL,
    status           TEXT NOT NULL CHECK (status IN ('answered', 'timed_out', 'skipped')),
    chosen_place     INTEGER,
    correct          INTEGER CHECK (correct IN (0, 1)),
    check_passed     INTEGER CHECK (check_passed IN (0, 1)),
    onset_s          REAL NOT NULL,
    onset_utc_s      REAL NOT NULL,
    motion_end_s     REAL NOT NULL,
    motion_end_utc_s REAL NOT NULL,
    answered_s       REAL NOT NULL,
    answered_utc_s   REAL NOT NULL,
    response_time_s  REAL NOT NULL,
    paused_s         REAL NOT NULL,
    replays          INTEGER NOT NULL,
    pauses           INTEGER NOT NULL,
    begun_before     INTEGER NOT NULL CHECK (begun_before IN (0, 1)),
    reason           TEXT,
    input            TEXT NOT NULL,
    head_x_m         REAL NOT NULL,
    head_y_m         REAL NOT NULL,
    head_z_m         REAL NOT NULL,
    head_qw          REAL NOT NULL,
    head_qx          REAL NOT NULL,
    head_qy          REAL NOT NULL,
    head_qz          REAL NOT NULL,
    ray_x_m          REAL,
    ray_y_m          REAL,
    ray_z_m          REAL,
    ray_dx           REAL,
    ray_dy           REAL,
    ray_dz           REAL,
    superseded       TEXT,               -- why the trial was done again; NULL: the answer that counts
    superseded_utc_s REAL,
    viewer_x_m       REAL,               -- where the participant was asked to stand
    viewer_z_m       REAL,
    viewer_heading_deg REAL,
    hash             TEXT,               -- SHA-256 of the answer's content; NULL before version 5
    FOREIGN KEY (participant, trial_index) REFERENCES trials (participant, trial_index),
    FOREIGN KEY (session, participant) REFERENCES sessions (id, participant),
    CHECK ((superseded IS NULL) = (superseded_utc_s IS NULL))
) STRICT;
INSERT INTO responses VALUES(1,'S001',0,1,'answered',NULL,NULL,NULL,0.03333333333333333287,0.03333333333333333287,0.03333333333333333287,0.03333333333333333287,1.0333333333333334369,1.0333333333333334369,1.0,0.0,0,0,0,NULL,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.99457411706381160243,-0.083726494421823366431,0.061525389320652094926,0.0051794080273914692297,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,-0.34846169053225700684,0.259755398394470427,-0.9006117827545514487,NULL,NULL,0.0,3.3999999999999999111,180.0,'74eabd82c215b64dc7fc5ff88fe366c5d6127489df46117c88827e37f324b58c');
INSERT INTO responses VALUES(2,'S001',1,1,'answered',NULL,NULL,NULL,1.0666666666666666518,1.0666666666666666518,1.0666666666666666518,1.0666666666666666518,3.0,3.0,1.9333333333333333481,0.0,0,0,0,NULL,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.97553144421037685241,-0.093107459276813728243,-0.19827078145291446298,-0.018923519912627438654,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,0.3588250190256726535,0.21194597790449695717,-0.90902338153170303414,NULL,NULL,0.0,3.3999999999999999111,180.0,'ef51370f94b8b54208bd260f6c3b006eca79e997d6814b61bce7cc82080d85ab');
INSERT INTO responses VALUES(3,'S001',2,1,'answered',NULL,NULL,NULL,3.6666666666666665186,3.6666666666666665186,6.6333333333333337478,6.6333333333333337478,7.8666666666666662521,7.8666666666666662521,1.2333333333333325043,0.0,0,0,0,NULL,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.97927006272242211881,-0.17305749182050694789,-0.10366126983402559891,-0.018319113428764369211,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,0.092860442189759459519,0.010581672318519957237,-0.99562290375787654284,NULL,NULL,0.0,3.3999999999999999111,180.0,'eea4b9e7282e04c9fb31f0333009d444fea39a9e081f4a961d0aff3893f3c831');
INSERT INTO responses VALUES(4,'S001',3,1,'answered',NULL,NULL,1,8.8666666666666671403,8.8666666666666671403,11.866666666666667139,11.866666666666667139,13.5,13.5,1.6333333333333328596,0.0,0,0,0,NULL,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.96640341062474732769,-0.16102662583940027807,0.1976124477863930029,0.032927104086208067168,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,-0.63519367904554580039,0.0082082519748523721792,-0.77230927399591764448,NULL,NULL,0.0,3.3999999999999999111,180.0,'af23fc0b512a63b47304b8019ee74ec7fc435db8b7dc91fd3565a97f72556de7');
INSERT INTO responses VALUES(5,'S001',4,1,'answered',NULL,NULL,NULL,14.5,14.5,17.86666666666666714,17.86666666666666714,18.73333333333333428,18.73333333333333428,0.86666666666666714036,0.0,0,0,0,NULL,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.96644688869084893756,-0.16079867708650205648,-0.1975939513860668073,-0.032875935920507443066,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,0.37018044051423110163,0.0098726071599719612825,-0.92890740824290696231,NULL,NULL,0.0,3.3999999999999999111,180.0,'af00debfe7bf59f4c3f359fb3883d52e3f73afd04bc88bf791a1effa39817f6a');
INSERT INTO responses VALUES(6,'S001',5,1,'answered',0,1,NULL,19.73333333333333428,19.73333333333333428,22.73333333333333428,22.73333333333333428,23.533333333333334991,23.533333333333334991,0.80000000000000071054,0.0,0,0,0,NULL,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.9344236303855421033,-0.21470081016574735222,0.27695928580005235719,0.063636429035579394897,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,-0.71465975704194306672,-0.2124967389233304027,-0.66641321086222515823,NULL,NULL,0.0,3.3999999999999999111,180.0,'ead0c94e8954a015aee4591445e856c59d65493d6f17df67c919a75eb38ca80b');
INSERT INTO responses VALUES(7,'S001',6,1,'answered',0,1,NULL,25.266666666666665718,25.266666666666665718,28.433333333333333571,28.433333333333333571,29.633333333333332858,29.633333333333332858,1.1999999999999992894,0.0,0,0,0,NULL,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.93442362674837109448,-0.21470080865784885171,0.27695929860982132497,0.06363643177962155506,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,-0.71465975704194306672,-0.2124967389233304027,-0.66641321086222515823,NULL,NULL,0.0,3.3999999999999999111,180.0,'f4ae20c415a87af0ff09a92b0df7e0c65ea6e390613f453201d98be37de4d0b2');
INSERT INTO responses VALUES(8,'S001',7,1,'answered',NULL,NULL,NULL,31.333333333333332148,31.333333333333332148,31.333333333333332148,31.333333333333332148,34.233333333333334281,34.233333333333334281,2.9000000000000021316,0.0,0,0,0,NULL,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.97473551271100333792,-0.10088889529158777402,-0.19822003592000042582,-0.020516540320776127659,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,0.36052126257067734771,0.18939383660379552343,-0.91332053184571493353,'the phone rang',35.23333333333333428,0.0,3.3999999999999999111,180.0,NULL);
INSERT INTO responses VALUES(9,'S002',0,2,'answered',NULL,NULL,NULL,0.03333333333333333287,0.03333333333333333287,0.03333333333333333287,0.03333333333333333287,0.86666666666666669627,0.86666666666666669627,0.83333333333333337034,0.0,0,0,0,NULL,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.99457411706381160243,-0.083726494421823352554,0.061525389320652101865,0.0051794080273914692297,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,-0.34846169053225700684,0.259755398394470427,-0.9006117827545514487,NULL,NULL,0.0,3.3999999999999999111,180.0,'da3ae2b01b4020c9bb0ad720aa0ac3a96c00b12dc71f8acb81dc8f08660dcf84');
INSERT INTO responses VALUES(10,'S002',1,2,'answered',NULL,NULL,NULL,0.9000000000000000222,0.9000000000000000222,0.9000000000000000222,0.9000000000000000222,3.0666666666666668739,3.0666666666666668739,2.1666666666666669627,0.0,0,0,0,NULL,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.97552140321771618758,-0.093102764926627529229,-0.19832198863964936585,-0.018927647745292694447,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,0.3588250190256726535,0.21194597790449695717,-0.90902338153170303414,NULL,NULL,0.0,3.3999999999999999111,180.0,'176ee15b22b944edaec00d52232be75279d643253b70c346f4aa0589cbbd0152');
INSERT INTO responses VALUES(11,'S002',2,2,'answered',NULL,NULL,NULL,3.7333333333333333925,3.7333333333333333925,7.4000000000000003552,7.4000000000000003552,8.4333333333333335701,8.4333333333333335701,1.0333333333333332149,0.0,0,0,0,NULL,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.98409883354828708856,-0.17762174925638093969,6.1953378768996576401e-08,1.1182075553951314966e-08,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,-0.20735546037517180173,0.010396609069460972796,-0.9782104188631695063,NULL,NULL,0.0,3.3999999999999999111,180.0,'f70b1e1b4f09d2b43817f8e01669949a0f462ed347260285d0c43e19fe027d88');
INSERT INTO responses VALUES(12,'S002',3,2,'answered',NULL,NULL,1,9.4333333333333335701,9.4333333333333335701,12.433333333333333569,12.433333333333333569,13.5,13.5,1.0666666666666664298,0.0,0,0,0,NULL,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.97927746685471905863,-0.17301715389449071058,0.10365949281807834703,0.018314390995980152354,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,-0.45938555558160110159,0.0094398207351747073778,-0.88818680529912819032,NULL,NULL,0.0,3.3999999999999999111,180.0,'df0a158e53ecfdb0cde46dd1afee84442596978cd28eb8dd752efd2504f3da1c');
INSERT INTO responses VALUES(13,'S002',4,2,'answered',NULL,NULL,NULL,14.5,14.5,18.30000000000000071,18.30000000000000071,19.133333333333332859,19.133333333333332859,0.83333333333333214909,0.0,0,0,0,NULL,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.97931865734243839227,-0.17279229696700287854,-0.10365005026021381628,-0.018288153841375325014,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,0.092860442189759459519,0.010581672318519957237,-0.99562290375787654284,NULL,NULL,0.0,3.3999999999999999111,180.0,'16d2eba2b09f822e8ebfedb60292f72548fbce8e87cc67ef8a8324957c9df460');
INSERT INTO responses VALUES(14,'S002',5,2,'answered',1,1,NULL,20.13333333333333286,20.13333333333333286,23.13333333333333286,23.13333333333333286,23.733333333333334279,23.733333333333334279,0.60000000000000142108,0.0,0,0,0,NULL,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.97066383118203780622,-0.21187273569009490437,0.11105864572405164947,0.024241450372100060289,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,-0.4416266436734974099,-0.15201945233849956107,-0.88422621184196092958,NULL,NULL,0.0,3.3999999999999999111,180.0,'1365621ce4d06511579910af8c0950e2ea55fd9cd1eca561b0e0c58e983c46f8');
INSERT INTO responses VALUES(15,'S002',6,2,'answered',2,1,NULL,25.533333333333334991,25.533333333333334991,28.600000000000001421,28.600000000000001421,29.600000000000001421,29.600000000000001421,1.0,0.0,0,0,0,NULL,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.97066382670459316894,-0.21187274236136824367,0.1110586707469899681,0.024241456709125020624,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,-0.4416266436734974099,-0.15201945233849956107,-0.88422621184196092958,NULL,NULL,0.0,3.3999999999999999111,180.0,'5ece791d7209a2c77cdee3e9c847a57d890b38881b97890fd6d8f3459d68036a');
INSERT INTO responses VALUES(16,'S002',7,2,'answered',NULL,NULL,NULL,30.73333333333333428,30.73333333333333428,30.73333333333333428,30.73333333333333428,34.533333333333331438,34.533333333333331438,3.7999999999999971578,0.0,0,0,0,NULL,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.97473854012276828218,-0.10089513692949650391,-0.19820203905852828984,-0.020515883026433864161,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,0.36052126257067734771,0.18939383660379552343,-0.91332053184571493353,NULL,NULL,0.0,3.3999999999999999111,180.0,'dd2e97d660316cc85da3e1594b0feddc906b136bc8e65b934061e480c48fdc28');
CREATE TABLE response_stimuli (
    response  INTEGER NOT NULL REFERENCES responses (id),
    position  INTEGER NOT NULL,          -- as in trial_stimuli
    clip_file TEXT NOT NULL,
    clip_hash TEXT NOT NULL,
    plays     INTEGER NOT NULL,          -- to the end
    author       TEXT,                   -- who made the clip, and in which trial of theirs: as the manifest says
    author_trial INTEGER,
    PRIMARY KEY (response, position)
) STRICT, WITHOUT ROWID;
INSERT INTO response_stimuli VALUES(3,0,'clips/direct/T016.bvh','7e08eddc86ecc089921833a3b19d179076d8e2aa5e9179f583ff56a2082d71a2',1,NULL,NULL);
INSERT INTO response_stimuli VALUES(4,0,'clips/stiff/T009.bvh','52860b9a8ae1730e6406b05f9785347b426ce27716982a9ebe5ab7f3408fd957',1,NULL,NULL);
INSERT INTO response_stimuli VALUES(5,0,'clips/direct/T009.bvh','9f7c9ade67197baf1176f8fb24cbe20b20e06b4e1fb2088b6a706e080d64511e',1,NULL,NULL);
INSERT INTO response_stimuli VALUES(6,0,'clips/stiff/T010.bvh','77088a10553b064b5be3693e46e0d594e23dc5109ab678bfc80dd358c0e0e849',1,NULL,NULL);
INSERT INTO response_stimuli VALUES(7,0,'clips/direct/T010.bvh','922587bc82fec519957d8383561752b7509b05d3eafc4e212c6f9363881fd913',1,NULL,NULL);
INSERT INTO response_stimuli VALUES(11,0,'clips/direct/T013.bvh','5d87237d4966502fc4ef4a51820de30c741a145458e693ff9b26ceec30c61567',1,NULL,NULL);
INSERT INTO response_stimuli VALUES(12,0,'clips/stiff/T015.bvh','ce383c9873de1173198150964ac782e2da28d143555d15e13bd4f19e27764e5a',1,NULL,NULL);
INSERT INTO response_stimuli VALUES(13,0,'clips/direct/T015.bvh','5209af7336db233048ffdfbf4eae2205c928bddef6f10bc98dff0b6b32a72160',1,NULL,NULL);
INSERT INTO response_stimuli VALUES(14,0,'clips/stiff/T002.bvh','b01ae519052f1ea0ca9d96fae33b38ee1b03ea7fe23d0e2199f2cf175cc1de6b',1,NULL,NULL);
INSERT INTO response_stimuli VALUES(15,0,'clips/direct/T002.bvh','cc5b4977b60c0f195513e2e064e128144c517d29e7bf3689ea9920cf5a78c0ea',1,NULL,NULL);
CREATE TABLE answers (
    response INTEGER NOT NULL REFERENCES responses (id),
    position INTEGER NOT NULL,           -- order within the response
    question TEXT NOT NULL,              -- rating, preference, confidence, reasons, consent, or a question's id
    stimulus INTEGER,                    -- ratings: which, as in trial_stimuli
    value    REAL,
    text     TEXT,
    PRIMARY KEY (response, position)
) STRICT, WITHOUT ROWID;
INSERT INTO answers VALUES(1,0,'consent',NULL,1.0,NULL);
INSERT INTO answers VALUES(2,0,'age',NULL,86.0,NULL);
INSERT INTO answers VALUES(2,1,'glasses',NULL,1.0,'no');
INSERT INTO answers VALUES(3,0,'rating',0,4.0,NULL);
INSERT INTO answers VALUES(4,0,'rating',0,1.0,NULL);
INSERT INTO answers VALUES(5,0,'rating',0,5.0,NULL);
INSERT INTO answers VALUES(6,0,'confidence',NULL,4.0,NULL);
INSERT INTO answers VALUES(7,0,'confidence',NULL,3.0,NULL);
INSERT INTO answers VALUES(8,0,'mental',NULL,4.0,NULL);
INSERT INTO answers VALUES(8,1,'effort',NULL,4.0,NULL);
INSERT INTO answers VALUES(9,0,'consent',NULL,1.0,NULL);
INSERT INTO answers VALUES(10,0,'age',NULL,72.0,NULL);
INSERT INTO answers VALUES(10,1,'glasses',NULL,1.0,'no');
INSERT INTO answers VALUES(11,0,'rating',0,3.0,NULL);
INSERT INTO answers VALUES(12,0,'rating',0,2.0,NULL);
INSERT INTO answers VALUES(13,0,'rating',0,4.0,NULL);
INSERT INTO answers VALUES(14,0,'confidence',NULL,4.0,NULL);
INSERT INTO answers VALUES(15,0,'confidence',NULL,4.0,NULL);
INSERT INTO answers VALUES(16,0,'mental',NULL,1.0,NULL);
INSERT INTO answers VALUES(16,1,'effort',NULL,1.0,NULL);
CREATE TABLE events (
    id          INTEGER PRIMARY KEY,
    session     INTEGER NOT NULL REFERENCES sessions (id),
    kind        TEXT NOT NULL,
    trial_index INTEGER,
    time_s      REAL NOT NULL,
    utc_s       REAL NOT NULL,
    detail      TEXT NOT NULL
) STRICT;
INSERT INTO events VALUES(1,1,'session_start',NULL,0.03333333333333333287,0.03333333333333333287,'');
INSERT INTO events VALUES(2,1,'stage_start',NULL,0.03333333333333333287,0.03333333333333333287,'consent');
INSERT INTO events VALUES(3,1,'stage_start',NULL,1.0666666666666666518,1.0666666666666666518,'before');
INSERT INTO events VALUES(4,1,'stage_start',NULL,3.0333333333333332149,3.0333333333333332149,'rating-practice');
INSERT INTO events VALUES(5,1,'stimulus_onset',2,3.6666666666666665186,3.6666666666666665186,'');
INSERT INTO events VALUES(6,1,'motion_end',2,6.6333333333333337478,6.6333333333333337478,'');
INSERT INTO events VALUES(7,1,'stage_start',NULL,8.2333333333333325043,8.2333333333333325043,'rating');
INSERT INTO events VALUES(8,1,'stimulus_onset',3,8.8666666666666671403,8.8666666666666671403,'');
INSERT INTO events VALUES(9,1,'motion_end',3,11.866666666666667139,11.866666666666667139,'');
INSERT INTO events VALUES(10,1,'stimulus_onset',4,14.5,14.5,'');
INSERT INTO events VALUES(11,1,'motion_end',4,17.86666666666666714,17.86666666666666714,'');
INSERT INTO events VALUES(12,1,'stage_start',NULL,19.100000000000001421,19.100000000000001421,'game');
INSERT INTO events VALUES(13,1,'stimulus_onset',5,19.73333333333333428,19.73333333333333428,'');
INSERT INTO events VALUES(14,1,'motion_end',5,22.73333333333333428,22.73333333333333428,'');
INSERT INTO events VALUES(15,1,'stimulus_onset',6,25.266666666666665718,25.266666666666665718,'');
INSERT INTO events VALUES(16,1,'motion_end',6,28.433333333333333571,28.433333333333333571,'');
INSERT INTO events VALUES(17,1,'stage_start',NULL,31.333333333333332148,31.333333333333332148,'load');
INSERT INTO events VALUES(18,1,'finished',NULL,35.13333333333333286,35.13333333333333286,'');
INSERT INTO events VALUES(19,2,'session_start',NULL,0.03333333333333333287,0.03333333333333333287,'');
INSERT INTO events VALUES(20,2,'stage_start',NULL,0.03333333333333333287,0.03333333333333333287,'consent');
INSERT INTO events VALUES(21,2,'stage_start',NULL,0.9000000000000000222,0.9000000000000000222,'before');
INSERT INTO events VALUES(22,2,'stage_start',NULL,3.1000000000000000888,3.1000000000000000888,'rating-practice');
INSERT INTO events VALUES(23,2,'stimulus_onset',2,3.7333333333333333925,3.7333333333333333925,'');
INSERT INTO events VALUES(24,2,'motion_end',2,7.4000000000000003552,7.4000000000000003552,'');
INSERT INTO events VALUES(25,2,'stage_start',NULL,8.8000000000000007105,8.8000000000000007105,'rating');
INSERT INTO events VALUES(26,2,'stimulus_onset',3,9.4333333333333335701,9.4333333333333335701,'');
INSERT INTO events VALUES(27,2,'motion_end',3,12.433333333333333569,12.433333333333333569,'');
INSERT INTO events VALUES(28,2,'stimulus_onset',4,14.5,14.5,'');
INSERT INTO events VALUES(29,2,'motion_end',4,18.30000000000000071,18.30000000000000071,'');
INSERT INTO events VALUES(30,2,'stage_start',NULL,19.5,19.5,'game');
INSERT INTO events VALUES(31,2,'stimulus_onset',5,20.13333333333333286,20.13333333333333286,'');
INSERT INTO events VALUES(32,2,'motion_end',5,23.13333333333333286,23.13333333333333286,'');
INSERT INTO events VALUES(33,2,'stimulus_onset',6,25.533333333333334991,25.533333333333334991,'');
INSERT INTO events VALUES(34,2,'motion_end',6,28.600000000000001421,28.600000000000001421,'');
INSERT INTO events VALUES(35,2,'stage_start',NULL,30.73333333333333428,30.73333333333333428,'load');
INSERT INTO events VALUES(36,2,'finished',NULL,35.3333333333333357,35.3333333333333357,'');
CREATE TABLE tracking_blocks (
    id                   INTEGER PRIMARY KEY,
    session              INTEGER NOT NULL REFERENCES sessions (id),
    trial_index          INTEGER,
    first_frame          INTEGER NOT NULL,
    frames               INTEGER NOT NULL,
    first_display_time_s REAL NOT NULL,
    last_display_time_s  REAL NOT NULL,
    data                 BLOB NOT NULL,
    UNIQUE (session, first_frame)
) STRICT;
INSERT INTO tracking_blocks VALUES(1,1,NULL,1000,10,61.111111110999999595,61.211111111000001015,X'789c75935b4cdb7514c7ffe7fc7efff6dfdb8a651b91986916a30ffa644c8cfab8f8607cf055631613b31789d168e283c9b295963128e55e0695d141b9d3967b618542e960e356ba160a943f17b9544a4b8196ebca18a818588cfacdf79c9c9c9c976f3e3920f6c8f14c391b951fb92df0b73d67c3b97ff311e64c8e87c8fc5ba73b38ed69a0827fd685f3b31945fc85a0b75036b086a1f0c53e2f8c39d9348fe8b8eca2c37229e686be55f1bc921a4de2e0fda4d8d58d67d0cc0b322aa4a17e763f42dd5eb656af889cbc527e253e98b89929ac5349022a1c9e482cb7e3a43c8b8719ba3e8a6e2d7d7ec36987c75da00b616405eff2b42e4463c734a3104c0b30b04db60ce09802ed16a94a8896a0f69dde6bc132763c8376be00e70a59e803e32398e986ae3775df0d7fb5ea274d3ae2c9a2cf0b716599747e29e04eb30839a6a5105df60b59a6c4b4f79d85a2307f596f4a4895f43d835e0dd6b472969ca4a3e22b995b58312d290bb01b2a1c3de6ee0d5cee7c2c6f3a90efba849a4941e5aaa8d12139fe70f1874a3b37a049544631e3b5f621526614f279e4e9036c931ea7b3b63132e785073da0fe71f51ea49681791a164ae0404f0cc37092437abe36e4107f985857b05405b10362c845772d2dcd60ab6ee7c9371bb1e18b8ff7efc08e06f38ba0b119bdeb582f52fe627321f3124e7e25b79085ca5db95eab38bcaf507ff2c82818f626d41d51a62b28cc34c91a0615b162599d91e62db363d992f93a996b8a637ee7a50511816139a17a44e25812e85c973b6db4a5593cea44266a237b66d6538d9d3c6cd6a3ba0dac0fd1970d81dbccc11bde0ef477a2b71ff85ef2f0a79d313ae484130d326107043e9f9e23556f774cd0a526b27bb3fddb917c601a1ac0aac3f66e3ac10bf838d9cfc3fe65aa36437492fc1942243e0d91eac0492d0d2b392610973475e0e83467094ae7d7e8d024bd932957150b87ac62463f278ad6485b225c645858eb26c6dd0bf11d2e50c4198284f1b941370fd67a997947f8a44a66d324387912d6b09eeba92558fe6ef809c68ee868caf82e1ebe557fcb23af28c4fcabcd47d4d24e0c59a01dc4ea721aba614bd174507536553aa1db4275411af96c3d7936446af6b0eb1b930de674d8f8e9442b39cc2059265ad78d9b3c5a5fff2b8158740624b82d3e87e37372e7f35ab9f43f5ef0fff512717fba785bf36abc835843c976dfa50a8f822f100476643d1a69ab5ed2b5242fbabea44dae59940f45f1c444e3b9c4de4a6772a9ffa9c0fc48a23f4c9aeb91e6cea2cfcfd63e671f8fc38249d4b886b5ab327b11c91ea46ac57c1ffcba08253f87a3d0b60573c9c5d7341f8471af04cd3e4cbf8f2b56ccbfe93590c359da5d4387cbb1cbcf0e8ea0b500fdfda8bc8b9663c1f614316fc26c0862292e23b68dd0c552f6c12a71bce7cac1d45d986c07d5f77f0003cc02b4');
CREATE TABLE hand_joints (
    session INTEGER NOT NULL REFERENCES sessions (id),
    frame   INTEGER NOT NULL,
    hand    TEXT NOT NULL CHECK (hand IN ('left', 'right')),
    joints  BLOB NOT NULL,
    flags   BLOB NOT NULL,
    UNIQUE (session, frame, hand),
    CHECK (length(joints) = 32 * length(flags))
) STRICT;
INSERT INTO hand_joints VALUES(1,1001,'left',X'2895f73d0657aa3e34b3383faa10363f92ba6f3f691ed83e387d543f25992b3f1e539b3eaf6b163f25ea613f65a0583f485a013fdac8163ff56a0d3dd490783eaf224c3ff720d43eda28313e137e0c3f7bfa333f1aab2c3f13d9bf3e94bfe03e3d28023f0448473f385c053fbb58c93e1cb9fa3e3247f23cbb1f323dd910343f31b27b3fe4da173fe685c93e05702e3eb592003f60697b3f0141453f5e240a3ff33b5c3f94bf6d3e8a86033fe7d4733f5cea133f5013eb3e00df893e7c490c3f9305753fa613bb3ba19d483f5d0b523faadc623fa2913d3fcb234f3f1ac8043f26b50f3f8f28da3e8be1653dfcb85e3f7aeb113fb4a24c3e5c35013f1b48f83e2dadb63e2031b13ebfd9093f019d1f3fafc91c3f3892ea3ecb2be53c951d6b3ede76353e3a9f153f146b5c3f7f664c3f960e4c3f0a02513fe7b5823e977c573f2b512c3fa976aa3dcaba883cf68c6e3c236e413f748c7f3e933be03d08f31f3f3258b03e145e8e3de074233e6702073f302e2c3e71bb8b3ec22a363fa7cee83e6adda43e1d92f23e4d9dc13cd0eac53ea782d73e608d403e73bede3d815a663ff696023ff31b563eca0b1b3f8329513fbd8aaa3c9e58923c11fa153e9a05383fb412243e0961343fee9c2d3f9a710b3fe6e4613e90c0793f553d4c3fde3f043f6f8d643e8404263f1230ca3ea46a133f557aa43ecd85213fa9c8703de1e2983e83c8773f0323603fb5de9c3e9ac75b3ffbe79e3e3575703f706c3e3f8814d53e1535813eccf00a3ca8f3603f5d4e1b3d20c5513fd052763fe8fd113f2da22f3ee6265e3f5549793fdc3a343f8d45023f2285c13eeda0b13e36b3523e4b952c3fa3abdd3e0ac7463e5edcd53d317c2a3fd696973ec7e5ff3eb593a63e96225f3f5151663fbd37943c69ac4d3ea1cda73e4aaf7c3f0d5f483ff29dad3e7c245a3e16a92c3f9473563fd7a36e3f150db03e85e4613f74e62f3f3710f83e444a7c3f9545703e16b8393fd46cad3d4dc42d3e7f36693f56145a3e7055423f49a7193f7154573fa778bc3ede39ae3e2c1a953e3a0f5e3f999e1a3f7e4d743fce23633f23980a3e82190d3f218ed53df54e203d6ee6953d36bd5d3f00c2493ff818543f1d8aae3ed57c1d3fd62a483f698ec13ebd1e123f4d15653e0369a73d0090883e',X'0707070707070707070707070707070707070707070707070707');
CREATE TABLE trial_tracking (
    session               INTEGER NOT NULL REFERENCES sessions (id),
    trial_index           INTEGER NOT NULL,
    frames                INTEGER NOT NULL,
    dropped_frames        INTEGER NOT NULL,
    samples_missing       INTEGER NOT NULL,
    max_off_place_m       REAL NOT NULL,
    head_untracked_frames INTEGER NOT NULL,
    first_display_time_s  REAL NOT NULL,
    last_display_time_s   REAL NOT NULL,
    PRIMARY KEY (session, trial_index)
) STRICT, WITHOUT ROWID;
INSERT INTO trial_tracking VALUES(1,3,90,1,0,0.125,2,10.499999999999999999,11.499999999999999999);
CREATE INDEX sessions_of_participant ON sessions (participant);
CREATE UNIQUE INDEX responses_that_count ON responses (participant, trial_index) WHERE superseded IS NULL;
CREATE INDEX responses_of_participant ON responses (participant, session);
CREATE INDEX events_of_session ON events (session);
CREATE INDEX tracking_of_trial ON tracking_blocks (session, trial_index);
CREATE VIEW responses_flat AS
SELECT p.id AS participant, p.number AS participant_number,
       -- As who counts is told everywhere (standing.hpp): without consent nobody is active.
       CASE WHEN p.status = 'active' AND EXISTS
                 (SELECT 1 FROM consents AS c WHERE c.participant = p.id AND c.agreed = 0 AND c.session =
                  (SELECT max(o.session) FROM consents AS o WHERE o.participant = c.participant AND o.stage = c.stage))
            THEN 'dropped' ELSE p.status END AS participant_status,
       r.trial_index, t.stage, t.kind, t.practice, t.attempt, r.status,
       a.question, CASE WHEN t.kind <> 'pairwise' THEN s.position END AS stimulus, s.system, s.item,
       coalesce(s.scored, 0) AS scored,
       a.value, a.text, r.chosen_place, t.target_place, r.correct, t.check_kind, r.check_passed,
       t.layout, t.distance, t.target_id, r.response_time_s, r.replays, x.plays, r.pauses, r.paused_s,
       r.begun_before, r.input, k.dropped_frames, k.samples_missing, k.max_off_place_m,
       s.clip, x.clip_file, x.clip_hash, x.author, x.author_trial,
       t.target_x_m, t.target_y_m, t.target_z_m, t.distractors, t.balls,
       coalesce(r.viewer_x_m, l.viewer_x_m) AS viewer_x_m, coalesce(r.viewer_z_m, l.viewer_z_m) AS viewer_z_m,
       coalesce(r.viewer_heading_deg, l.heading_deg) AS heading_deg,
       r.onset_s, r.motion_end_s, r.answered_s, r.onset_utc_s, r.motion_end_utc_s, r.answered_utc_s,
       strftime('%Y-%m-%dT%H:%M:%fZ', r.answered_utc_s, 'unixepoch') AS answered_utc,
       r.head_x_m, r.head_y_m, r.head_z_m, r.head_qw, r.head_qx, r.head_qy, r.head_qz,
       r.ray_x_m, r.ray_y_m, r.ray_z_m, r.ray_dx, r.ray_dy, r.ray_dz,
       r.session, e.station, e.station_details, e.synthetic, e.program_version, e.avatar_hash, r.id AS response,
       o.system AS other_system             -- pairwise: stood right; `system` stood left
  FROM responses AS r
  JOIN participants AS p ON p.id = r.participant
  JOIN trials AS t ON t.participant = r.participant AND t.trial_index = r.trial_index
  JOIN sessions AS e ON e.id = r.session
  LEFT JOIN answers AS a ON a.response = r.id
  LEFT JOIN trial_stimuli AS s ON s.participant = r.participant AND s.trial_index = r.trial_index
        AND (s.position = a.stimulus OR (a.stimulus IS NULL AND s.position = 0))
  LEFT JOIN trial_stimuli AS o ON o.participant = r.participant AND o.trial_index = r.trial_index
        AND o.position = 1 AND t.kind = 'pairwise'
  LEFT JOIN response_stimuli AS x ON x.response = r.id AND x.position = s.position AND t.kind <> 'pairwise'
  LEFT JOIN layouts AS l ON l.name = t.layout
  LEFT JOIN trial_tracking AS k ON k.session = r.session AND k.trial_index = r.trial_index
 WHERE r.superseded IS NULL
 ORDER BY r.participant, r.trial_index, a.position
;
COMMIT;
