package org.dronemap.proxy.outlet;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.MessageTable;
import org.dronemap.mavlink.PayloadWriter;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.LogRequestData;
import org.dronemap.mavlink.message.ManualControl;
import org.dronemap.mavlink.message.MissionClearAll;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItem;
import org.dronemap.mavlink.message.MissionRequestList;
import org.dronemap.mavlink.message.MissionSetCurrent;
import org.dronemap.mavlink.message.ParamRequestList;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.RcChannelsOverride;
import org.dronemap.mavlink.message.SetMode;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;

/** What a sender says for one row: every message filled in some ways, and those that can mean something so that they do. */
final class MatrixMessages {
    private static final int LATITUDE = 473_977_500;
    private static final int LONGITUDE = 85_456_000;
    private static final double E7 = 1e7;
    /** Passes without a throttle alone. */
    private static final int CHANGE_SPEED = 178;

    private static final Map<Integer, List<Message>> SENSIBLE = sensible();

    private MatrixMessages() {}

    /** A message by its number, all of it zeros or all of it the same letter, for the vehicle, and once for everybody. */
    static List<Message> ofMessage(MessageTable.Entry entry) {
        List<Message> words = new ArrayList<>();
        words.add(new Filled(entry, 0, 1));
        words.add(new Filled(entry, MatrixTestBench.FILL, 1));
        words.add(new Filled(entry, MatrixTestBench.FILL, 0));
        words.addAll(SENSIBLE.getOrDefault(entry.id(), List.of()));
        return words;
    }

    /** A command in both forms, with a place and a height, and zeros or ones before. */
    static List<Message> ofCommand(int number) {
        List<Message> words = new ArrayList<>();
        for (int value = 0; value < 2; value++) {
            words.add(new CommandLong(
                    1, 1, number, 0, value, value, 1, 1, (float) (LATITUDE / E7), (float) (LONGITUDE / E7), 30));
            words.add(new CommandInt(1, 1, 6, number, 0, 0, value, value, 1, 1, LATITUDE, LONGITUDE, 30));
        }
        if (number == CHANGE_SPEED) {
            words.add(new CommandLong(1, 1, number, 0, 1, 5, -1, 0, 0, 0, 0));
            words.add(new CommandInt(1, 1, 6, number, 0, 0, 0, 4, -1, 0, 0, 0, 0));
        }
        return words;
    }

    private static Map<Integer, List<Message>> sensible() {
        List<Message> counts = new ArrayList<>();
        List<Message> clears = new ArrayList<>();
        List<Message> lists = new ArrayList<>();
        for (int kind = 0; kind < 3; kind++) {
            counts.add(new MissionCount(1, 1, kind == 0 ? 2 : 1, kind));
            clears.add(new MissionClearAll(1, 1, kind));
            lists.add(new MissionRequestList(1, 1, kind));
        }
        clears.add(new MissionClearAll(1, 1, 255));
        MissionItem here = new MissionItem(
                1, 1, 0, 3, 16, 2, 1, 0, 0, 0, 0, (float) (LATITUDE / E7), (float) (LONGITUDE / E7), 30, 0);
        return Map.ofEntries(
                Map.entry(SetMode.ID, List.of(new SetMode(1, 1, 5))),
                Map.entry(ParamRequestList.ID, List.of(new ParamRequestList(1, 1))),
                Map.entry(ParamRequestRead.ID, List.of(new ParamRequestRead(1, 1, "RTL_ALT", -1))),
                Map.entry(ParamSet.ID, List.of(new ParamSet(1, 1, "RTL_ALT", 2_000, 9))),
                Map.entry(MissionCount.ID, counts),
                Map.entry(MissionClearAll.ID, clears),
                Map.entry(MissionRequestList.ID, lists),
                Map.entry(MissionItem.ID, List.of(here)),
                Map.entry(MissionSetCurrent.ID, List.of(new MissionSetCurrent(1, 1, 1))),
                Map.entry(LogRequestData.ID, List.of(new LogRequestData(1, 1, 1, 0, 90))),
                Map.entry(ManualControl.ID, List.of(new ManualControl(1, 300, 0, 500, 0, 0, 0, 0, 0, 0))),
                Map.entry(
                        RcChannelsOverride.ID,
                        List.of(new RcChannelsOverride(
                                1, 1, 1600, 1500, 1500, 1500, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0))),
                Map.entry(
                        SetPositionTargetLocalNed.ID,
                        List.of(new SetPositionTargetLocalNed(0, 1, 1, 1, 0xDC7, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0))),
                Map.entry(SetPositionTargetGlobalInt.ID, List.of(target(0xDF8), target(0xDC0))));
    }

    private static SetPositionTargetGlobalInt target(int mask) {
        return new SetPositionTargetGlobalInt(0, 1, 1, 6, mask, LATITUDE, LONGITUDE, 30, 1, 0, 0, 0, 0, 0, 0, 0);
    }

    /** A message that is one letter throughout, but for whom it is for. */
    private record Filled(MessageTable.Entry entry, int letter, int target) implements Message {
        @Override
        public int messageId() {
            return entry.id();
        }

        @Override
        public void write(PayloadWriter out) {
            for (int at = 0; at < entry.longestPayload(); at++) {
                boolean whom = entry.targetOffset() >= 0 && at == entry.targetOffset();
                out.u8(whom ? target : letter);
            }
        }
    }
}
