// OpenSees numbers its classes here.
#pragma once
