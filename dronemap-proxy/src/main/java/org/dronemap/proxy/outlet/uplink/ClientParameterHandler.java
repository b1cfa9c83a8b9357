package org.dronemap.proxy.outlet.uplink;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.core.access.Principal;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterSet;
import org.dronemap.core.parameter.ParameterType;
import org.dronemap.core.parameter.ParameterValue;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.ParamValue;
import org.dronemap.proxy.mavlink.procedure.ParameterCodec;
import org.dronemap.proxy.mavlink.translate.AutopilotAdapter;

/**
 * Serves the cloud's copy of a drone's parameters to ground stations at the outlet, and writes their changes. Owned by
 * the outlet's thread.
 */
final class ClientParameterHandler {
    private static final int AT_ONCE = 32;
    /** Of a parameter whose place in the list is not known. */
    private static final int NO_PLACE = 0xFFFF;

    private final CloudManager cloud;
    private final ClientCommandExecutor orders;
    private final Map<TransferKey, Listing> listings = new LinkedHashMap<>();
    private final Map<DroneId, List<ClientRequest>> readings = new LinkedHashMap<>();

    private record TransferKey(String client, DroneId drone) {}

    /** A list that is on its way to a client. */
    private static final class Listing {
        private final ClientRequest asked;
        private final List<Parameter> parameters;
        private int next;

        Listing(ClientRequest asked, List<Parameter> parameters) {
            this.asked = asked;
            this.parameters = parameters;
        }
    }

    ClientParameterHandler(CloudManager cloud, ClientCommandExecutor orders) {
        this.cloud = cloud;
        this.orders = orders;
    }

    /** PARAM_REQUEST_LIST. */
    void list(ClientRequest asked) {
        ParameterSet known = known(asked);
        if (known.readAt() != null) {
            begin(asked, known);
            return;
        }
        List<ClientRequest> waiting = readings.get(asked.drone());
        if (waiting != null) {
            waiting.add(asked);
            return;
        }
        Principal principal = asked.client().principal();
        if (principal == null || !asked.client().mayOrder()) {
            return;
        }
        readings.put(asked.drone(), new ArrayList<>(List.of(asked)));
        read(asked, principal);
    }

    /** Has the vehicle read by the right of this one. */
    private void read(ClientRequest asked, Principal principal) {
        orders.submit(principal, asked.drone(), new Command.ReadParameters(), new Reading(asked));
    }

    /** PARAM_REQUEST_READ, by name or by place in the list. */
    void read(ClientRequest asked) {
        ParamRequestRead wanted = ParamRequestRead.decode(asked.frame());
        List<Parameter> all = known(asked).all();
        // The place is a signed number; -1: by name.
        int index = (short) wanted.paramIndex();
        if (index < 0) {
            index = indexOf(all, wanted.paramId());
        }
        if (index >= 0 && index < all.size()) {
            sendAt(asked, all, index);
        }
    }

    /** PARAM_SET: answered with the value that holds in the end. */
    void set(ClientRequest asked) {
        ParamSet wanted = ParamSet.decode(asked.frame());
        Principal principal = asked.client().principal();
        if (principal == null || !asked.client().mayOrder()) {
            return;
        }
        ParameterType type = known(asked)
                .find(wanted.paramId())
                .map(Parameter::type)
                .orElse(ParameterCodec.type(wanted.paramType()));
        double value = codec(asked).decode(type, wanted.paramValue());
        if (!ParameterValue.isName(wanted.paramId()) || !Double.isFinite(value)) {
            asked.explain("This is no parameter, or no value for one.");
            return;
        }
        Command command = new Command.SetParameters(List.of(new ParameterValue(wanted.paramId(), value)));
        orders.submit(
                principal,
                asked.drone(),
                command,
                new Setting(asked, new Parameter(wanted.paramId(), type, type.held(value))));
    }

    /** Goes on with what is on its way; false when there is nothing. */
    boolean serve() {
        for (Iterator<Listing> each = listings.values().iterator(); each.hasNext(); ) {
            Listing listing = each.next();
            for (int count = 0;
                    count < AT_ONCE
                            && listing.next < listing.parameters.size()
                            && listing.asked.client().hasRoom();
                    count++) {
                sendAt(listing.asked, listing.parameters, listing.next++);
            }
            if (listing.next == listing.parameters.size()) {
                each.remove();
            }
        }
        return !listings.isEmpty();
    }

    /** The client has gone. */
    void forget(String client) {
        listings.keySet().removeIf(place -> place.client().equals(client));
        readings.values()
                .forEach(
                        waiting -> waiting.removeIf(asked -> asked.client().id().equals(client)));
    }

    private void begin(ClientRequest asked, ParameterSet known) {
        listings.put(new TransferKey(asked.client().id(), asked.drone()), new Listing(asked, known.all()));
    }

    private void sendAt(ClientRequest asked, List<Parameter> all, int index) {
        send(asked, all.get(index), all.size(), index);
    }

    private static void send(ClientRequest asked, Parameter parameter, int count, int index) {
        asked.answer(new ParamValue(
                parameter.name(),
                codec(asked).encode(parameter.type(), parameter.value()),
                ParameterCodec.number(parameter.type()),
                count,
                index));
    }

    private ParameterSet known(ClientRequest asked) {
        return cloud.onBoard(asked.drone()).parameters();
    }

    private static ParameterCodec codec(ClientRequest asked) {
        Frame beat = asked.vehicle().newest(Heartbeat.ID);
        return new ParameterCodec(
                beat != null && AutopilotAdapter.of(Heartbeat.decode(beat)).parametersAsBits());
    }

    private static int indexOf(List<Parameter> all, String name) {
        for (int index = 0; index < all.size(); index++) {
            if (all.get(index).name().equals(name)) {
                return index;
            }
        }
        return -1;
    }

    /** Reads by the right of one, for all who wait. */
    private final class Reading implements ClientCommandExecutor.Callback {
        private final ClientRequest by;

        Reading(ClientRequest by) {
            this.by = by;
        }

        @Override
        public void accepted() {
            // The list itself is the answer.
        }

        @Override
        public void ended(Outcome outcome) {
            if (outcome instanceof Outcome.Refused refused) {
                by.explain(refused.reason());
                readByTheNext();
                return;
            }
            List<ClientRequest> waiting = readings.remove(by.drone());
            if (waiting == null) {
                return;
            }
            String why = OutcomeTranslator.sentence(outcome);
            for (ClientRequest asked : waiting) {
                if (why.isEmpty()) {
                    begin(asked, known(asked));
                } else {
                    asked.explain(why);
                }
            }
        }

        /** What one may not have done, another may. */
        private void readByTheNext() {
            List<ClientRequest> waiting = readings.getOrDefault(by.drone(), List.of());
            waiting.remove(by);
            for (ClientRequest next : waiting) {
                Principal principal = next.client().principal();
                if (principal != null) {
                    read(next, principal);
                    return;
                }
            }
            readings.remove(by.drone());
        }
    }

    /** Tells what holds after a change, or without it. */
    private final class Setting implements ClientCommandExecutor.Callback {
        private final ClientRequest asked;
        private final Parameter wanted;

        Setting(ClientRequest asked, Parameter wanted) {
            this.asked = asked;
            this.wanted = wanted;
        }

        @Override
        public void accepted() {
            // The value that is read back is the answer.
        }

        @Override
        public void ended(Outcome outcome) {
            String why = OutcomeTranslator.sentence(outcome);
            if (!why.isEmpty()) {
                asked.explain(why);
            }
            List<Parameter> all = known(asked).all();
            int index = indexOf(all, wanted.name());
            if (index >= 0) {
                sendAt(asked, all, index);
            } else if (why.isEmpty()) {
                // It was read back, though nobody has asked for the whole list yet.
                send(asked, wanted, all.size(), NO_PLACE);
            }
        }
    }
}
