package org.dronemap.sim;

/** A kind of vehicle that exchanges were recorded of; their names begin with its name, those of ArduCopter with none. */
enum RecordedVehicle {
    COPTER("arducopter"),
    ROVER("ardurover");

    private static final String HOME = "-35.3632610,149.1652299,584.05";

    private final String personality;

    RecordedVehicle(String personality) {
        this.personality = personality;
    }

    static RecordedVehicle of(RecordedExchange exchange) {
        for (RecordedVehicle vehicle : values()) {
            if (exchange.name().startsWith(vehicle.name() + "_")) {
                return vehicle;
            }
        }
        return COPTER;
    }

    /** The simulator's options for one where the real ones stood. */
    String[] options() {
        return new String[] {"--home", HOME, "--stick", "low", "--personality", personality};
    }

    /** The same with so many seconds until the position is known. */
    String[] optionsReadyAfter(String seconds) {
        return new String[] {"--home", HOME, "--stick", "low", "--personality", personality, "--ready-after", seconds};
    }
}
