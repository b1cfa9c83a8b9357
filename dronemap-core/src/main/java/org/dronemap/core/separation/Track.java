package org.dronemap.core.separation;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.dronemap.core.geo.PlanePoint;

/**
 * One way that a drone may fly in the next seconds: piecewise linear in position and time, a sample every
 * {@link #STRIDE_SECONDS}. Never changes.
 */
record Track(List<TrackSample> samples) {
    static final double STRIDE_SECONDS = 0.5;
    /** As a share of the least distance: by so much less two who leave each other may be apart at first. */
    static final double LEAVING = 0.02;
    /** Beyond this nothing depends on how far apart two are. */
    private static final double FAR_APART = 8;

    Track {
        samples = List.copyOf(samples);
    }

    static int strides(double seconds) {
        return (int) Math.ceil(seconds / STRIDE_SECONDS);
    }

    /** It stays there for so many strides. */
    static Track standing(TrackSample there, int strides) {
        return new Track(Collections.nCopies(strides + 1, there));
    }

    /** As if it stopped after so many strides. */
    Track stopping(int after) {
        List<TrackSample> stands = new ArrayList<>();
        for (int i = 0; i < samples.size(); i++) {
            stands.add(samples.get(Math.min(i, after)));
        }
        return new Track(stands);
    }

    /** As if it set off so many strides later. */
    Track after(int strides) {
        List<TrackSample> later = new ArrayList<>();
        for (int i = 0; i < samples.size(); i++) {
            later.add(samples.get(Math.max(0, i - strides)));
        }
        return new Track(later);
    }

    /** Standing where it comes to in the end. */
    Track last() {
        return standing(samples.get(samples.size() - 1), samples.size() - 1);
    }

    /** Its first part. */
    Track until(int strides) {
        return new Track(samples.subList(0, Math.min(samples.size(), strides + 1)));
    }

    /** The least distance, as a share of the one that is asked for: from 1 on they are apart all the time. */
    double clearance(Track other, Separation least) {
        int shared = Math.min(samples.size(), other.samples.size());
        double clearance = between(0, 0, other, least);
        for (int i = 1; i < shared && clearance > 0; i++) {
            clearance = Math.min(clearance, between(i - 1, i, other, least));
        }
        return clearance;
    }

    /** The same at its beginning. */
    private double clearanceNow(Track other, Separation least) {
        return between(0, 0, other, least);
    }

    private double clearanceAtTheEnd(Track other, Separation least) {
        int last = Math.min(samples.size(), other.samples.size()) - 1;
        return between(last, last, other, least);
    }

    /** Between two samples both move straight and evenly: the nearest is found in closed form. */
    private double between(int from, int to, Track other, Separation least) {
        TrackSample mine = samples.get(from);
        TrackSample myNext = samples.get(to);
        TrackSample yours = other.samples.get(from);
        TrackSample yourNext = other.samples.get(to);
        double mineOver = Math.min(mine.low(), myNext.low()) - Math.max(yours.high(), yourNext.high());
        double yoursOver = Math.min(yours.low(), yourNext.low()) - Math.max(mine.high(), myNext.high());
        double stacked = Math.max(mineOver, yoursOver) / least.verticalMeters();
        if (stacked >= FAR_APART) {
            return FAR_APART;
        }
        double reach = Math.max(mine.reach(), myNext.reach()) + Math.max(yours.reach(), yourNext.reach());
        double beside = Math.max(0, nearest(mine, myNext, yours, yourNext) - reach) / least.horizontalMeters();
        return Math.min(FAR_APART, Math.max(stacked, beside));
    }

    private static double nearest(TrackSample mine, TrackSample myNext, TrackSample yours, TrackSample yourNext) {
        double east = mine.spot().eastMeters() - yours.spot().eastMeters();
        double north = mine.spot().northMeters() - yours.spot().northMeters();
        double eastward = myNext.spot().eastMeters() - yourNext.spot().eastMeters() - east;
        double northward = myNext.spot().northMeters() - yourNext.spot().northMeters() - north;
        double squared = eastward * eastward + northward * northward;
        double share = squared == 0 ? 0 : Math.max(0, Math.min(1, -(east * eastward + north * northward) / squared));
        return Math.hypot(east + share * eastward, north + share * northward);
    }

    /** They come too near to each other, and not since they are leaving each other. */
    boolean conflicts(Track other, Separation least) {
        double clearance = clearance(other, least);
        return clearance < 1 && !leaves(other, least, clearance);
    }

    /** Never nearer than now, and apart in the end: that is over the sooner the less either of them is stopped. */
    private boolean leaves(Track other, Separation least, double clearance) {
        return clearanceAtTheEnd(other, least) >= 1 && clearance >= clearanceNow(other, least) - LEAVING;
    }

    /** Apart all along, or never nearer than they are now: who came too near already may leave. */
    boolean isPassable(Track other, Separation least) {
        return clearance(other, least) >= Math.min(1, clearanceNow(other, least) - LEAVING);
    }

    /** Whether they begin within so many metres of each other on the ground, at about one height. */
    boolean beginsNear(Track other, double meters, Separation least) {
        return clearanceNow(other, new Separation(meters, least.verticalMeters())) < 1;
    }

    /**
     * They come too near to each other if either may be early or late.
     *
     * @param seconds by so much at least
     * @param share and by such a share of the time until then
     */
    boolean meets(Track other, Separation least, double seconds, double share) {
        for (int i = 0; i < samples.size(); i++) {
            int wide = (int) Math.ceil((seconds + share * i * STRIDE_SECONDS) / STRIDE_SECONDS);
            int last = Math.min(other.samples.size() - 1, i + wide);
            for (int j = Math.max(0, i - wide); j <= last; j++) {
                if (samples.get(i).isNear(other.samples.get(j), least)) {
                    return true;
                }
            }
        }
        return false;
    }

    PlanePoint begin() {
        return samples.get(0).spot();
    }
}
