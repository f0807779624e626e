-- A database of version 1 as the sqlite3 shell dumps it: written by the program when that was the newest version
-- (deixis simulate, a small study), then one answer was taken away, another made to have been interrupted for
-- 0.5 s, and a session added that did not end.
PRAGMA application_id=0x44584953;
PRAGMA user_version=1;
PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE study (
    id           INTEGER PRIMARY KEY CHECK (id = 1), -- one study a database
    name         TEXT NOT NULL,
    title        TEXT NOT NULL,
    hash         TEXT NOT NULL,
    source       TEXT,
    alpha        REAL NOT NULL,
    rating_steps INTEGER NOT NULL
) STRICT;
INSERT INTO study VALUES(1,'kept','How an avatar points','0963c968ace2b800a37ce7c82d4853ebde138afc50bb0842ce99760927fa543b',replace('# The perceptual study of Deichler, Wang, Alexanderson and Beskow (2023), "Learning to generate pointing gestures\n\n[study]\nname = "kept"\ntitle = "How an avatar points"\ndescription = """\nNaturalness ratings, then a referential game with three balls: 5 and 10 items for each of 4 systems, the same\nitems for all systems of a participant."""\nreference = "Deichler et al. 2023, sections 2.4.2, 2.4.3 and 3.1"\nseed = 2023\neye_height_m = 1.65\ninter_trial_s = 0.6\n\n[texts]\nwelcome = """\nWelcome, and thank you for taking part!\n\nYou are about to meet an avatar that points at things. There are two parts. In the first you tell us how natural\nits movements look. In the second you find out what it is pointing at.\n\nIt takes about 15 minutes. Your impression is what counts, so there is no need to hurry. You may pause or stop at\nany time."""\nbreak = """\nTime for a short break. Stretch, look into the distance, have a sip of water.\n\nGo on whenever you feel ready."""\ngoodbye = """\nThat was all. Thank you very much for your help!\n\nPlease tell the experimenter that you have finished."""\n\n[targets]\ncount = 100                              # "the sampled 100 test positions" (2.4.3)\n\nheight_m = [0.1, 2.1]\narc_deg = [-85.0, 85.0]\nradius_m = [1.9, 2.2]\n\nball_diameter_m = 0.10\ndistractors = 2                          # "1 pointing target and 2 distractors" (2.4.2)\ndistractor_distance_m = [0.20, 0.40]     # "within 20-40 cm away from the input test position" (2.4.3)\n\n[[layouts]]\nname = "across"                          # "the avatar is facing the user"\nviewer_m = [0.0, 3.4]\nheading_deg = 180.0\n\n[[layouts]]\nname = "side-by-side"                    # "the user stands by the shoulder of the avatar"\nviewer_m = [-0.6, -0.95]\n\nheading_deg = 15.0\n\n[[systems]]\nname = "direct"\ngenerator = "direct"\n\n[[systems]]\nname = "stiff"\ngenerator = "stiff"\n\n[naturalness]\nitems = 2\npractice = 1\nbreak_every = 20\nmax_replays = 0\nlayout = "across"                        # "facing the user"\nquestion = "How natural do you find the animation?"\nlabels = [\n    "very unnatural",\n    "rather unnatural",\n    "neither",\n    "rather natural",\n    "very natural",\n]\ninstructions = """\nPart 1: how natural does it look?\n\nThe avatar before you will raise an arm, point somewhere and lower the arm again. You will not see what it points\nat, and it does not matter here: please judge only the movement. Does it move as a person would?\n\nAfter each movement, answer the question on the board from 1 (very unnatural) to 5 (very natural): aim at a number\nand click, or press its key."""\npractice_instructions = """\nFirst a few movements to try it out. These answers do not count."""\n\n[game]\nitems = 2\npractice = 1\nbreak_every = 20\nmax_replays = 0\nlayouts = ["across", "side-by-side"]\nquestion = "Which ball did the avatar point at?"\ninstructions = """\nPart 2: which ball does it mean?\n\nNow there are three black balls in the room. The avatar points at one of them: watch its arm and hand closely, they\ntell you which ball it means. Sometimes you stand across from it, sometimes at its side.\n\nWhen the movement is over the balls turn white. Then it is your turn: aim at the ball that you think it meant and\nclick. If you are not sure, take your best guess."""\npractice_instructions = """\nAgain, first a few rounds to try it out. These answers do not count."""\n\n[analysis]\nalpha = 0.01\n','\n',char(10)),0.010000000000000000208,5);
CREATE TABLE systems (
    position  INTEGER PRIMARY KEY,
    name      TEXT NOT NULL UNIQUE,
    generator TEXT,
    manifest  TEXT
) STRICT;
INSERT INTO systems VALUES(0,'direct','direct',NULL);
INSERT INTO systems VALUES(1,'stiff','stiff',NULL);
CREATE TABLE layouts (
    position    INTEGER PRIMARY KEY,
    name        TEXT NOT NULL UNIQUE,
    viewer_x_m  REAL NOT NULL,
    viewer_z_m  REAL NOT NULL,
    heading_deg REAL NOT NULL
) STRICT;
INSERT INTO layouts VALUES(0,'across',0.0,3.3999999999999999111,180.0);
INSERT INTO layouts VALUES(1,'side-by-side',-0.59999999999999997779,-0.94999999999999995559,15.0);
CREATE TABLE participants (
    id TEXT PRIMARY KEY
) STRICT, WITHOUT ROWID;
INSERT INTO participants VALUES('S001');
CREATE TABLE plans (
    participant TEXT PRIMARY KEY REFERENCES participants (id),
    seed        TEXT NOT NULL,
    hash        TEXT NOT NULL,
    json        TEXT NOT NULL
) STRICT, WITHOUT ROWID;
INSERT INTO plans VALUES('S001','2023','7f472f06683a2f7029a5e1b0ac92d51868ece933a239c52bba2fdae25cb352a6',replace('{\n  "participant": "S001",\n  "study": "kept",\n  "study_hash": "0963c968ace2b800a37ce7c82d4853ebde138afc50bb0842ce99760927fa543b",\n  "seed": 2023,\n  "trials": [\n    {"index":0,"stage":"naturalness","practice":true,"system":"direct","target_id":"T071","layout":"across","target":[-1.3272,0.5871,1.7329],"distractors":[],"ball_order":[]},\n    {"index":1,"stage":"naturalness","practice":false,"system":"direct","target_id":"T008","layout":"across","target":[-1.5691,0.5009,1.3567],"distractors":[],"ball_order":[]},\n    {"index":2,"stage":"naturalness","practice":false,"system":"stiff","target_id":"T008","layout":"across","target":[-1.5691,0.5009,1.3567],"distractors":[],"ball_order":[]},\n    {"index":3,"stage":"naturalness","practice":false,"system":"direct","target_id":"T018","layout":"across","target":[-1.8599,1.4242,0.5323],"distractors":[],"ball_order":[]},\n    {"index":4,"stage":"naturalness","practice":false,"system":"stiff","target_id":"T018","layout":"across","target":[-1.8599,1.4242,0.5323],"distractors":[],"ball_order":[]},\n    {"index":5,"stage":"game","practice":true,"system":"stiff","target_id":"T069","layout":"across","target":[1.7731,1.0171,0.7386],"distractors":[[1.8253,0.729,0.8757],[1.7656,0.7495,0.7863]],"ball_order":[2,0,1]},\n    {"index":6,"stage":"game","practice":false,"system":"stiff","target_id":"T055","layout":"across","target":[0.1425,0.4542,1.9457],"distractors":[[0.3151,0.493,2.0569],[-0.0067,0.5888,2.1622]],"ball_order":[2,0,1]},\n    {"index":7,"stage":"game","practice":false,"system":"direct","target_id":"T038","layout":"side-by-side","target":[-2.0745,1.9591,0.4138],"distractors":[[-2.1129,1.6766,0.5967],[-2.0328,1.7533,0.4545]],"ball_order":[1,2,0]},\n    {"index":8,"stage":"game","practice":false,"system":"direct","target_id":"T055","layout":"across","target":[0.1425,0.4542,1.9457],"distractors":[[0.3151,0.493,2.0569],[-0.0067,0.5888,2.1622]],"ball_order":[2,0,1]},\n    {"index":9,"stage":"game","practice":false,"system":"stiff","target_id":"T038","layout":"side-by-side","target":[-2.0745,1.9591,0.4138],"distractors":[[-2.1129,1.6766,0.5967],[-2.0328,1.7533,0.4545]],"ball_order":[0,1,2]}\n  ]\n}\n','\n',char(10)));
CREATE TABLE trials (
    participant  TEXT NOT NULL REFERENCES plans (participant),
    trial_index  INTEGER NOT NULL,
    stage        TEXT NOT NULL CHECK (stage IN ('naturalness', 'game')),
    practice     INTEGER NOT NULL CHECK (practice IN (0, 1)),
    system       TEXT NOT NULL REFERENCES systems (name),
    target_id    TEXT NOT NULL,
    layout       TEXT NOT NULL REFERENCES layouts (name),
    target_x_m   REAL NOT NULL,
    target_y_m   REAL NOT NULL,
    target_z_m   REAL NOT NULL,
    distractors  TEXT NOT NULL,
    balls        TEXT,
    target_place INTEGER,
    PRIMARY KEY (participant, trial_index),
    CHECK ((stage = 'game') = (balls IS NOT NULL)),
    CHECK ((stage = 'game') = (target_place IS NOT NULL))
) STRICT, WITHOUT ROWID;
INSERT INTO trials VALUES('S001',0,'naturalness',1,'direct','T071','across',-1.3271999999999999353,0.58709999999999995523,1.7329000000000001069,'[]',NULL,NULL);
INSERT INTO trials VALUES('S001',1,'naturalness',0,'direct','T008','across',-1.5690999999999999392,0.5009000000000000119,1.356700000000000017,'[]',NULL,NULL);
INSERT INTO trials VALUES('S001',2,'naturalness',0,'stiff','T008','across',-1.5690999999999999392,0.5009000000000000119,1.356700000000000017,'[]',NULL,NULL);
INSERT INTO trials VALUES('S001',3,'naturalness',0,'direct','T018','across',-1.8599000000000001087,1.4241999999999999104,0.53229999999999999538,'[]',NULL,NULL);
INSERT INTO trials VALUES('S001',4,'naturalness',0,'stiff','T018','across',-1.8599000000000001087,1.4241999999999999104,0.53229999999999999538,'[]',NULL,NULL);
INSERT INTO trials VALUES('S001',5,'game',1,'stiff','T069','across',1.7730999999999998983,1.017099999999999893,0.73860000000000003428,'[[1.8253,0.729,0.8757],[1.7656,0.7495,0.7863]]','[[1.7656,0.7495,0.7863],[1.7731,1.0171,0.7386],[1.8253,0.729,0.8757]]',1);
INSERT INTO trials VALUES('S001',6,'game',0,'stiff','T055','across',0.14249999999999998778,0.45419999999999999262,1.945699999999999985,'[[0.3151,0.493,2.0569],[-0.0067,0.5888,2.1622]]','[[-0.0067,0.5888,2.1622],[0.1425,0.4542,1.9457],[0.3151,0.493,2.0569]]',1);
INSERT INTO trials VALUES('S001',7,'game',0,'direct','T038','side-by-side',-2.0745000000000000106,1.9591000000000000635,0.41380000000000000115,'[[-2.1129,1.6766,0.5967],[-2.0328,1.7533,0.4545]]','[[-2.1129,1.6766,0.5967],[-2.0328,1.7533,0.4545],[-2.0745,1.9591,0.4138]]',2);
INSERT INTO trials VALUES('S001',8,'game',0,'direct','T055','across',0.14249999999999998778,0.45419999999999999262,1.945699999999999985,'[[0.3151,0.493,2.0569],[-0.0067,0.5888,2.1622]]','[[-0.0067,0.5888,2.1622],[0.1425,0.4542,1.9457],[0.3151,0.493,2.0569]]',1);
INSERT INTO trials VALUES('S001',9,'game',0,'stiff','T038','side-by-side',-2.0745000000000000106,1.9591000000000000635,0.41380000000000000115,'[[-2.1129,1.6766,0.5967],[-2.0328,1.7533,0.4545]]','[[-2.0745,1.9591,0.4138],[-2.1129,1.6766,0.5967],[-2.0328,1.7533,0.4545]]',0);
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
    outcome         TEXT CHECK (outcome IN ('finished', 'quit')),
    UNIQUE (id, participant),
    CHECK ((ended_utc_s IS NULL) = (outcome IS NULL))
) STRICT;
INSERT INTO sessions VALUES(1,'S001','simulated','virtual time, nothing drawn',1,'deixis 0.1.0','2ab41a1835afaec852d559a901a72562bcc63361d2725d13cdd4b7db56326de6',1700000000.0,1700000100.0,'quit');
INSERT INTO sessions VALUES(2,'S001','simulated','virtual time, nothing drawn',1,'deixis 0.1.0','2ab41a1835afaec852d559a901a72562bcc63361d2725d13cdd4b7db56326de6',1700000200.0,NULL,NULL);
CREATE TABLE responses (
    id               INTEGER PRIMARY KEY,
    participant      TEXT NOT NULL,
    trial_index      INTEGER NOT NULL,
    session          INTEGER NOT NULL,
    clip_file        TEXT NOT NULL,
    clip_hash        TEXT NOT NULL,
    rating           INTEGER,
    chosen_place     INTEGER,
    correct          INTEGER CHECK (correct IN (0, 1)),
    onset_s          REAL NOT NULL,
    onset_utc_s      REAL NOT NULL,
    motion_end_s     REAL NOT NULL,
    motion_end_utc_s REAL NOT NULL,
    answered_s       REAL NOT NULL,
    answered_utc_s   REAL NOT NULL,
    response_time_s  REAL NOT NULL,
    replays          INTEGER NOT NULL,
    pauses           INTEGER NOT NULL,
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
    UNIQUE (participant, trial_index),
    FOREIGN KEY (participant, trial_index) REFERENCES trials (participant, trial_index),
    FOREIGN KEY (session, participant) REFERENCES sessions (id, participant),
    CHECK ((rating IS NULL) <> (chosen_place IS NULL)),
    CHECK ((chosen_place IS NULL) = (correct IS NULL))
) STRICT;
INSERT INTO responses VALUES(1,'S001',1,1,'stimuli/direct-a05b83ee8c05/direct_T008.bvh','60a05e76467be0a08bacd6c48824348897f1a02b6bcf35fa830f37f71c2e124d',4,NULL,NULL,10.033333333333333215,10.033333333333333215,13.566666666666666429,13.566666666666666429,14.666666666666666074,14.666666666666666074,1.0999999999999996447,0,0,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.99853162114921678593,-0.054171962906245173241,3.5527948385565918999e-08,1.9274489273187093346e-09,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,0.09369573377896843469,-0.017423153089871634691,-0.99544841313250764791);
INSERT INTO responses VALUES(2,'S001',2,1,'stimuli/stiff-5e0819b4158f/stiff_T008.bvh','b6288f6e2fc4e5c913678eee52ac74d959fc29269401912024319dbfed9f6c13',2,NULL,NULL,15.666666666666666074,15.666666666666666074,18.66666666666666785,18.66666666666666785,19.43333333333333357,19.43333333333333357,0.76666666666666571927,0,0,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.99853162152271979223,-0.054171956021615778886,5.6189684386998569294e-22,3.0483812889562041535e-23,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,-0.46266504020665388807,-0.015514453093518723245,-0.88639740653714937934);
INSERT INTO responses VALUES(3,'S001',3,1,'stimuli/direct-a05b83ee8c05/direct_T018.bvh','3d0d9fbe2522ae3884fd3134c5f74630e717f38f598b7971052eb59a94a263e9',3,NULL,NULL,20.433333333333333569,20.433333333333333569,24.0,24.0,25.333333333333332149,25.333333333333332149,1.333333333333332149,0,0,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.9985316215009925056,-0.054171956422107245265,4.7011939206384110324e-09,2.5504737828720469476e-10,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,-0.20915513471797145261,-0.017113078528645447179,-0.97773272020751123001);
INSERT INTO responses VALUES(4,'S001',4,1,'stimuli/stiff-5e0819b4158f/stiff_T018.bvh','d4350ec33fe2bc96471f48f4e340c170bfeb4320f9a078637b66931e9307f184',1,NULL,NULL,26.333333333333332148,26.333333333333332148,29.333333333333332149,29.333333333333332149,30.30000000000000071,30.30000000000000071,0.96666666666666856144,0,0,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.99853162152271979223,-0.054171956021615778886,1.959906352696939503e-23,1.0632809062458744659e-24,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,-0.63861326168337184672,-0.01346684370544704197,-0.76940999871507931295);
INSERT INTO responses VALUES(5,'S001',6,1,'stimuli/stiff-5e0819b4158f/stiff_T055.bvh','ad7788493de74892315fa23a28b9f4019379b67cb631c6cbbec86a4dcbab0228',NULL,2,0,39.700000000000002843,39.700000000000002843,42.70000000000000284,42.70000000000000284,43.266666666666665718,43.266666666666665718,0.5666666666666628771,0,0,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.97934837555658049712,-0.2007267902281319738,-0.023704641555240667932,-0.0048584923727347907942,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,0.096212957013955671681,-0.54919124898496030073,-0.83013977072597244788);
INSERT INTO responses VALUES(6,'S001',7,1,'stimuli/direct-a05b83ee8c05/direct_T038.bvh','65635f3c9059812fa62d54bfa7d452571dd1ca02ed44bfdd7574abaffd074838',NULL,2,1,44.866666666666667139,44.866666666666667139,48.299999999999997158,48.299999999999997158,49.033333333333331436,49.033333333333331436,0.23333333333333428072,0,1,'ray',-0.59999999999999997779,1.6499999999999999111,-0.94999999999999995559,0.068164734692105891089,-0.0054108514547132162408,0.99453104062762165415,0.078944922946507331551,-0.70259849947193142583,1.1499999999999999111,-0.56016215177832195948,-0.73485082130517276333,0.43338956863095201565,0.52169699273523750804);
INSERT INTO responses VALUES(7,'S001',8,1,'stimuli/direct-a05b83ee8c05/direct_T055.bvh','a2dee316891db748fc04c807963e5c49c2eb98c87a09c703f73217e5d8bf0597',NULL,1,1,50.633333333333332857,50.633333333333332857,53.86666666666666714,53.86666666666666714,54.633333333333332858,54.633333333333332858,0.76666666666666571927,0,0,'ray',0.0,1.6499999999999999111,3.3999999999999999111,0.97934836266281000138,-0.2007268392997941242,-0.023704753755959921679,-0.0048585166210687808288,0.20000000000000009436,1.1499999999999999111,3.0499999999999998223,-0.044010971812477886477,-0.53257102934125311044,-0.84524028126120398507);
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
INSERT INTO events VALUES(2,1,'instructions_read',NULL,0.83333333333333337034,0.83333333333333337034,'welcome');
INSERT INTO events VALUES(3,1,'stage_start',NULL,0.83333333333333337034,0.83333333333333337034,'naturalness');
INSERT INTO events VALUES(4,1,'instructions_read',NULL,1.7333333333333333925,1.7333333333333333925,'instructions');
INSERT INTO events VALUES(5,1,'instructions_read',NULL,2.7999999999999998223,2.7999999999999998223,'practice');
INSERT INTO events VALUES(6,1,'stimulus_onset',0,3.433333333333333126,3.433333333333333126,'');
INSERT INTO events VALUES(7,1,'motion_end',0,6.9000000000000003552,6.9000000000000003552,'');
INSERT INTO events VALUES(8,1,'practice_answer',0,7.8666666666666662521,7.8666666666666662521,'rating 3');
INSERT INTO events VALUES(9,1,'instructions_read',NULL,9.4000000000000003552,9.4000000000000003552,'begin');
INSERT INTO events VALUES(10,1,'stimulus_onset',1,10.033333333333333215,10.033333333333333215,'');
INSERT INTO events VALUES(11,1,'motion_end',1,13.566666666666666429,13.566666666666666429,'');
INSERT INTO events VALUES(12,1,'stimulus_onset',2,15.666666666666666074,15.666666666666666074,'');
INSERT INTO events VALUES(13,1,'motion_end',2,18.66666666666666785,18.66666666666666785,'');
INSERT INTO events VALUES(14,1,'stimulus_onset',3,20.433333333333333569,20.433333333333333569,'');
INSERT INTO events VALUES(15,1,'motion_end',3,24.0,24.0,'');
INSERT INTO events VALUES(16,1,'stimulus_onset',4,26.333333333333332148,26.333333333333332148,'');
INSERT INTO events VALUES(17,1,'motion_end',4,29.333333333333332149,29.333333333333332149,'');
INSERT INTO events VALUES(18,1,'stage_start',NULL,30.66666666666666785,30.66666666666666785,'game');
INSERT INTO events VALUES(19,1,'instructions_read',NULL,31.833333333333332149,31.833333333333332149,'instructions');
INSERT INTO events VALUES(20,1,'instructions_read',NULL,33.36666666666666714,33.36666666666666714,'practice');
INSERT INTO events VALUES(21,1,'stimulus_onset',5,34.0,34.0,'');
INSERT INTO events VALUES(22,1,'motion_end',5,37.0,37.0,'');
INSERT INTO events VALUES(23,1,'practice_answer',5,37.933333333333330017,37.933333333333330017,'place 1, correct');
INSERT INTO events VALUES(24,1,'instructions_read',NULL,39.066666666666669982,39.066666666666669982,'begin');
INSERT INTO events VALUES(25,1,'stimulus_onset',6,39.700000000000002843,39.700000000000002843,'');
INSERT INTO events VALUES(26,1,'motion_end',6,42.70000000000000284,42.70000000000000284,'');
INSERT INTO events VALUES(27,1,'stimulus_onset',7,44.866666666666667139,44.866666666666667139,'');
INSERT INTO events VALUES(28,1,'motion_end',7,48.299999999999997158,48.299999999999997158,'');
INSERT INTO events VALUES(29,1,'stimulus_onset',8,50.633333333333332857,50.633333333333332857,'');
INSERT INTO events VALUES(30,1,'motion_end',8,53.86666666666666714,53.86666666666666714,'');
INSERT INTO events VALUES(31,1,'stimulus_onset',9,56.233333333333334279,56.233333333333334279,'');
INSERT INTO events VALUES(32,1,'motion_end',9,59.233333333333334281,59.233333333333334281,'');
CREATE INDEX events_of_session ON events (session);
CREATE VIEW responses_flat AS
SELECT r.participant, r.trial_index, t.stage, t.practice, t.system, t.layout, t.target_id,
       r.rating, r.chosen_place, t.target_place, r.correct, r.response_time_s, r.replays, r.pauses, r.input,
       r.clip_file, r.clip_hash,
       t.target_x_m, t.target_y_m, t.target_z_m, t.distractors, t.balls,
       l.viewer_x_m, l.viewer_z_m, l.heading_deg,
       r.onset_s, r.motion_end_s, r.answered_s, r.onset_utc_s, r.motion_end_utc_s, r.answered_utc_s,
       strftime('%Y-%m-%dT%H:%M:%fZ', r.answered_utc_s, 'unixepoch') AS answered_utc,
       r.head_x_m, r.head_y_m, r.head_z_m, r.head_qw, r.head_qx, r.head_qy, r.head_qz,
       r.ray_x_m, r.ray_y_m, r.ray_z_m, r.ray_dx, r.ray_dy, r.ray_dz,
       r.session, s.station, s.station_details, s.synthetic, s.program_version, s.avatar_hash
  FROM responses AS r
  JOIN trials AS t ON t.participant = r.participant AND t.trial_index = r.trial_index
  JOIN sessions AS s ON s.id = r.session
  JOIN layouts AS l ON l.name = t.layout
 ORDER BY r.participant, r.trial_index;
COMMIT;
