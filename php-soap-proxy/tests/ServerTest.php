<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Tests;

use Dronemap\SoapProxy\Contract\Contract;
use PHPUnit\Framework\TestCase;

/**
 * The proxy as it runs, before a server as it ships; what REST answers is what is right.
 *
 * Both are started by whoever runs this: DRONEMAP_PHP_PROXY and DRONEMAP_URL say where they are, DRONEMAP_KEY is an
 * administrator's key; DRONEMAP_USER, DRONEMAP_PASSWORD and DRONEMAP_VIEWER_KEY are a viewer's; the copter
 * DRONEMAP_DRONE stands disarmed.
 *
 * @group server
 */
final class ServerTest extends TestCase
{
    private Browser $browser;

    protected function setUp(): void
    {
        $this->browser = new Browser(self::setting('DRONEMAP_PHP_PROXY'));
    }

    private static function setting(string $name): string
    {
        $value = getenv($name);
        self::assertIsString($value, "$name is not set.");
        return $value;
    }

    /** @param array<string, mixed>|null $body @return array{status: int, type: string, json: mixed} */
    private static function rest(
        string $method,
        string $path,
        ?array $body = null,
        ?string $key = null
    ): array {
        $headers = ['Authorization: Bearer ' . ($key ?? self::setting('DRONEMAP_KEY'))];
        $headers[] = 'Content-Type: application/json';
        $address = self::setting('DRONEMAP_URL') . "/api/v1$path";
        $answer = file_get_contents($address, false, stream_context_create(['http' => [
            'method' => $method,
            'header' => implode("\r\n", $headers),
            'content' => $body === null ? '' : json_encode((object) $body),
            'ignore_errors' => true,
        ]]));
        preg_match('/^HTTP\S+ (\d+)/', $http_response_header[0], $status);
        return ['status' => (int) $status[1], 'type' => '', 'json' => json_decode((string) $answer)];
    }

    private function signInAsAdministrator(): void
    {
        $answer = $this->browser->signIn(['key' => self::setting('DRONEMAP_KEY')]);
        self::assertSame(200, $answer['status']);
    }

    private function signInAsViewer(): void
    {
        $proof = ['user' => self::setting('DRONEMAP_USER'), 'password' => self::setting('DRONEMAP_PASSWORD')];
        $answer = $this->browser->signIn($proof);
        self::assertSame([200, $proof['user']], [$answer['status'], $answer['json']->user ?? null]);
    }

    private function drone(): string
    {
        return self::setting('DRONEMAP_DRONE');
    }

    public function testSessionTellsWhoseItIsAndEnds(): void
    {
        $this->signInAsViewer();
        $told = $this->browser->ask('GET', 'session.php');
        self::assertSame([200, self::setting('DRONEMAP_USER')], [$told['status'], $told['json']->user]);
        self::assertNotEmpty(self::keysOfThePage());
        self::assertSame(204, $this->browser->ask('DELETE', 'session.php')['status']);
        self::assertSame([], self::keysOfThePage());
        self::assertSame('proxy-signed-out', $this->browser->call('getDronesList')['json']->code);
    }

    /** @return list<mixed> */
    private static function keysOfThePage(): array
    {
        $keys = self::rest('GET', '/users/' . self::setting('DRONEMAP_USER') . '/access-keys')['json']->accessKeys;
        return array_values(array_filter($keys, static fn ($key): bool => $key->label === 'PHP page'));
    }

    public function testKeyOfASessionCannotMakeRights(): void
    {
        $this->signInAsViewer();
        $keys = self::keysOfThePage();
        self::assertNotContains('administer', $keys[0]->operations);
        self::assertNotNull($keys[0]->expiresAt);
        $this->browser->ask('DELETE', 'session.php');
    }

    public function testWrongKeyIsRefusedAsRestRefusesIt(): void
    {
        $this->isRefusedAs(self::rest('GET', '/settings', null, 'wrong'), ['key' => 'wrong']);
    }

    public function testWrongPasswordIsRefusedAsRestRefusesIt(): void
    {
        $rest = self::rest('POST', '/session', ['name' => 'nobody', 'password' => 'wrong']);
        $this->isRefusedAs($rest, ['user' => 'nobody', 'password' => 'wrong']);
    }

    /** @param array{status: int, type: string, json: mixed} $rest @param array<string, string> $proof */
    private function isRefusedAs(array $rest, array $proof): void
    {
        $told = $this->browser->signIn($proof);
        self::assertSame('application/problem+json', $told['type']);
        self::assertEquals([$rest['status'], $rest['json']], [$told['status'], $told['json']]);
        self::assertSame(401, $told['status']);
    }

    /**
     * @dataProvider faults
     * @param array<string, mixed> $arguments
     * @param array<string, mixed> $body
     */
    public function testFaultIsTheProblemThatRestHas(
        string $operation,
        array $arguments,
        string $rest,
        array $body
    ): void {
        $this->signInAsAdministrator();
        $drone = $this->drone();
        $arguments = array_map(static fn (mixed $value): mixed => $value === 'DRONE' ? $drone : $value, $arguments);
        $told = $this->browser->call($operation, $arguments);
        [$method, $path] = explode(' ', str_replace('DRONE', $drone, $rest));
        $expected = self::rest($method, $path, $body === [] ? null : $body);
        self::assertSame('application/problem+json', $told['type']);
        self::assertSame($expected['status'], $told['status']);
        self::assertGreaterThanOrEqual(400, $told['status']);
        self::assertEquals(self::lasting($expected['json']), self::lasting($told['json']));
    }

    /** @return array<string, array{string, array<string, mixed>, string, array<string, mixed>}> */
    public function faults(): array
    {
        $goTo = ['latitude' => 91, 'longitude' => 8.5, 'altitude' => 10];
        $gives = 'POST /drones/DRONE/commands';
        return [
            'unknown drone' => ['getDrone', ['droneId' => 'nosuchdrone'], 'GET /drones/nosuchdrone', []],
            'out of range' => ['goto', ['droneId' => 'DRONE'] + $goTo, $gives, ['type' => 'goTo'] + $goTo],
            'missing' => ['takeoff', ['droneId' => 'DRONE'], $gives, ['type' => 'takeOff']],
            'of another type' => [
                'takeoff', ['droneId' => 'DRONE', 'altitude' => 'x'], $gives, ['type' => 'takeOff', 'altitude' => 'x'],
            ],
            'unknown plan' => ['getPlan', ['planId' => 'nosuchplan'], 'GET /plans/nosuchplan', []],
            'control of none' => ['releaseControl', ['droneId' => 'nobodys'], 'DELETE /drones/nobodys/control', []],
        ];
    }

    private static function lasting(object $problem): object
    {
        unset($problem->commandId);
        return $problem;
    }

    public function testTooLowRoleIsToldAsRestTellsIt(): void
    {
        $this->signInAsViewer();
        $told = $this->browser->call('arm', ['droneId' => $this->drone()]);
        $path = '/drones/' . $this->drone() . '/commands';
        $rest = self::rest('POST', $path, ['type' => 'arm'], self::setting('DRONEMAP_VIEWER_KEY'));
        self::assertSame([403, 403], [$told['status'], $rest['status']]);
        self::assertSame([$rest['json']->code, $rest['json']->detail], [$told['json']->code, $told['json']->detail]);
        $this->browser->ask('DELETE', 'session.php');
    }

    public function testRefusedCommandIsAnOutcomeWithItsSentence(): void
    {
        $this->signInAsAdministrator();
        $drone = $this->drone();
        $told = $this->browser->call('takeoff', ['droneId' => $drone, 'altitude' => 10, 'wait' => 10]);
        $rest = self::rest('POST', "/drones/$drone/commands?wait=10", ['type' => 'takeOff', 'altitude' => 10]);
        $outcome = $told['json']->outcome;
        self::assertSame(200, $told['status']);
        self::assertSame(['refused', 'gate'], [$outcome->result, $outcome->by]);
        self::assertSame([$rest['json']->code, $rest['json']->detail], [$outcome->code, $outcome->reason]);
    }

    /** @dataProvider readings */
    public function testAnswerHasTheFormThatRestHas(string $operation, string $path): void
    {
        $this->signInAsAdministrator();
        $drone = $this->drone();
        $arguments = str_contains($path, 'DRONE') ? ['droneId' => $drone] : [];
        $told = $this->browser->call($operation, $arguments);
        $rest = self::rest('GET', str_replace('DRONE', $drone, $path));
        self::assertSame([200, 200], [$told['status'], $rest['status']]);
        self::assertEquals(self::form($rest['json']), self::form($told['json']));
    }

    /** @return array<string, array{string, string}> */
    public function readings(): array
    {
        $readings = [
            'getDrone' => '/drones/DRONE', 'getControl' => '/drones/DRONE/control', 'getFence' => '/drones/DRONE/fence',
            'getRallyPoints' => '/drones/DRONE/rally-points', 'listParameters' => '/drones/DRONE/parameters',
            'listMissions' => '/missions', 'listZones' => '/zones', 'listPlans' => '/plans', 'listRuns' => '/runs',
            'listVirtualDrones' => '/virtual-drones', 'listWarehouse' => '/warehouse', 'getFollowsList' => '/follows',
        ];
        $cases = [];
        foreach ($readings as $operation => $path) {
            $cases[$operation] = [$operation, $path];
        }
        return $cases;
    }

    /** Names and types, without what has changed between two calls; lists by their first element. */
    private static function form(mixed $json): mixed
    {
        if (isset($json->type, $json->coordinates)) {
            // A choice of SOAP is named by its element.
            $json = (object) [$json->type => (object) ['coordinates' => $json->coordinates]];
        }
        if (is_object($json)) {
            $members = array_map(self::form(...), (array) $json);
            ksort($members);
            return $members;
        }
        if (is_array($json)) {
            return ['list', $json === [] ? null : self::form($json[0])];
        }
        return is_int($json) || is_float($json) ? 'number' : gettype($json);
    }

    /** @dataProvider operations */
    public function testEachOperationIsTheServersOwn(string $operation): void
    {
        $told = self::viewersBrowser()->call($operation);
        $code = $told['json']->code ?? '';
        self::assertLessThan(500, $told['status'], $code);
        self::assertStringStartsNotWith('proxy-', $code);
        // A viewer who says nothing is shown lists, or told what is missing, or that it is not for viewers.
        self::assertContains($told['status'], [200, 204, 403, 404, 422], $told['json']->detail ?? '');
    }

    /** One for all of them, signed in once. */
    private static function viewersBrowser(): Browser
    {
        static $browser = null;
        if ($browser === null) {
            $browser = new Browser(self::setting('DRONEMAP_PHP_PROXY'));
            $browser->signIn(['key' => self::setting('DRONEMAP_VIEWER_KEY')]);
        }
        return $browser;
    }

    /** @return array<string, array{string}> */
    public function operations(): array
    {
        $names = array_keys(Contract::written()->operations);
        return array_combine($names, array_map(static fn (string $name): array => [$name], $names));
    }

    public function testReadingByGetIsThePapersWay(): void
    {
        $this->signInAsAdministrator();
        $drone = $this->drone();
        $told = $this->browser->ask('GET', "proxy.php?operation=getDrone&droneId=$drone");
        self::assertSame([200, $drone], [$told['status'], $told['json']->id]);
        self::assertSame('application/json', $told['type']);
    }

    public function testMissionGoesThereAndBack(): void
    {
        $this->signInAsAdministrator();
        $items = [
            ['takeOff' => ['altitude' => 10]],
            ['waypoint' => ['latitude' => 47.3979, 'longitude' => 8.5456, 'altitude' => 12]],
            ['returnToLaunch' => []],
        ];
        $name = 'saved by PHP ' . bin2hex(random_bytes(4));
        $saved = $this->browser->call('addMission', ['name' => $name, 'items' => array_map(
            static fn (array $item): object => (object) array_map(static fn (array $of): object => (object) $of, $item),
            $items,
        )]);
        self::assertSame(200, $saved['status'], (string) json_encode($saved['json']));
        $read = $this->browser->call('getMission', ['missionId' => $saved['json']->id])['json'];
        self::assertSame([$name, 3], [$read->name, count($read->items)]);
        self::assertEqualsWithDelta(47.3979, $read->items[1]->waypoint->latitude, 1e-9);
        self::assertSame(204, $this->browser->call('deleteMission', ['missionId' => $saved['json']->id])['status']);
    }

    public function testStolenCookieWithoutTheTokenIsOfNoUse(): void
    {
        $this->signInAsAdministrator();
        $this->browser->token = '';
        foreach (['proxy.php?operation=getDronesList', 'session.php'] as $path) {
            $told = $this->browser->ask('GET', $path);
            self::assertSame([403, 'proxy-token-wrong'], [$told['status'], $told['json']->code]);
        }
        self::assertSame(403, $this->browser->ask('DELETE', 'session.php')['status']);
    }

    public function testTokenWithoutTheCookieIsOfNoUse(): void
    {
        $this->signInAsAdministrator();
        $this->browser->forgetCookie();
        self::assertSame('proxy-signed-out', $this->browser->call('getDronesList')['json']->code);
    }
}
