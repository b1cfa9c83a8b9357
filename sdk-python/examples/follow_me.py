"""A drone follows a walker: this program, which reports a position each second. Writes follow.csv: how far it was.

A phone does the same from its page. When no more positions come, the drone holds, and flies home by itself.
"""

import csv
import itertools
import time
from pathlib import Path

from dronemap import Dronemap, models

STEP = 0.000013
SECONDS = 20

with Dronemap.connect() as server:
    drone = server.drones()[0]
    drone.wait_for(lambda state: state.ready_to_arm is True and state.position is not None, timeout=60)
    place = drone.state.position
    assert place is not None and place.latitude is not None and place.longitude is not None
    latitude, longitude = place.latitude + 0.0002, place.longitude

    beside = models.FollowPlaceRequest(distance=8, height=10)
    follow = server.follow(latitude, longitude, drone=drone.id, minutes=5, place=beside, name="Walk")
    follow.report(latitude, longitude, accuracy=3, speed=1.4, course=0)
    follow.start()
    with Path("follow.csv").open("w", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(["second", "state", "distance", "height"])
        tracked = 0
        for second in itertools.count():
            latitude += STEP
            follow.report(latitude, longitude, accuracy=3, speed=1.4, course=0)
            view = server.rest.get_follow(follow.id)
            now = view.now
            rows.writerow([second, view.state, now.distance if now else None, now.height if now else None])
            tracked += view.state == "tracking"
            if tracked == SECONDS or view.state == "over" or second == 300:
                break
            time.sleep(1)
    follow.stop()
    print(f"The walk is over; the drone followed for {tracked} s and returns.")
    drone.wait_for(lambda state: state.flight == "onGround", timeout=300)
